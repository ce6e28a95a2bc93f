#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/stat.h>

#include <filesystem>

#include "acquire/open_measurement.hpp"
#include "support/files/hdf5_builder.hpp"
#include "support/files/mat_builder.hpp"
#include "support/input_error.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// Files of level 7.3 whose HDF5 objects link to other files. The reader must refuse them before it opens a linked file.
namespace percuss::mat_links_test {

using acquire::open_measurement;
using testing::AllOf;
using testing::HasSubstr;

constexpr hsize_t kSamples = 200;

class MatLinks : public testing::Test {
 protected:
  MatLinks() {
    const std::string secret = "secret bytes of another file ";
    std::string bytes;
    while (bytes.size() < kSamples * sizeof(double)) bytes += secret;
    test::write_bytes(other_, bytes);
    std::vector<double> samples(kSamples, 1.5);
    samples[50] = 100;
    test::MatBuilder(path_, test::MatLevel::v73)
        .numbers("fs", {1, 1}, {1000})
        .numbers("force", {kSamples, 1}, samples)
        .numbers("accel", {kSamples, 1}, samples);
  }
  /// Changes the file with the HDF5 library.
  void change(const std::function<void(hid_t file)>& changes) const {
    const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    ASSERT_GE(file, 0);
    changes(file);
    ASSERT_GE(H5Fclose(file), 0);
  }
  /// Replaces the variable "accel" by a data set with this creation property list.
  static hid_t replace_accel(hid_t file, hid_t creation, hid_t type = H5T_IEEE_F64LE) {
    const hsize_t extent[] = {1, kSamples};
    const hid_t space = H5Screate_simple(2, extent, nullptr);
    H5Ldelete(file, "accel", H5P_DEFAULT);
    const hid_t set = H5Dcreate2(file, "accel", type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    EXPECT_GE(set, 0);
    H5Sclose(space);
    add_class(set, "double");
    return set;
  }
  static void add_class(hid_t object, const std::string& name) {
    const hid_t type = H5Tcopy(H5T_C_S1), scalar = H5Screate(H5S_SCALAR);
    H5Tset_size(type, name.size());
    const hid_t attribute = H5Acreate2(object, "MATLAB_class", type, scalar, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, type, name.c_str());
    H5Aclose(attribute);
    H5Sclose(scalar);
    H5Tclose(type);
  }
  /// The message with and without a sandbox, which must be equal.
  std::string refusal(const std::function<void(hid_t file)>& changes) const {
    change(changes);
    const std::string here = test::input_error_of([&] { open_measurement(path_); });
    const std::string there = test::input_error_of([&] { open_measurement(path_, {.read = {.sandboxed = true}}); });
    EXPECT_EQ(here, there);
    return here;
  }

  test::ScratchFolder folder_;
  std::string path_ = folder_.file("r.mat"), other_ = folder_.file("other");
};

TEST_F(MatLinks, AreNotNeededToReadAFile) {
  change([](hid_t file) {
    const hid_t type = H5Tcopy(H5T_IEEE_F64LE);
    H5Tcommit2(file, "a type", type, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Tclose(type);
  });
  const auto opened = open_measurement(path_, {.read = {.sandboxed = true}});
  EXPECT_EQ(std::get<acquire::Record>(opened).rows.at(0).samples, kSamples);
}

// h5py writes a text of fixed length without a null character at its end.
TEST_F(MatLinks, AreNotNeededForClassesInTextsOfAnyPadding) {
  for (const H5T_str_t padding : {H5T_STR_NULLPAD, H5T_STR_NULLTERM, H5T_STR_SPACEPAD}) {
    for (const std::size_t spare : {0U, 1U, 5U}) {
      change([&](hid_t file) {
        for (const char* name : {"fs", "force", "accel"}) {
          const hid_t set = H5Dopen2(file, name, H5P_DEFAULT);
          H5Adelete(set, "MATLAB_class");
          const hid_t type = H5Tcopy(H5T_C_S1), scalar = H5Screate(H5S_SCALAR);
          std::string text = "double";
          text.resize(text.size() + spare, padding == H5T_STR_SPACEPAD ? ' ' : '\0');
          H5Tset_size(type, text.size());
          H5Tset_strpad(type, padding);
          const hid_t attribute = H5Acreate2(set, "MATLAB_class", type, scalar, H5P_DEFAULT, H5P_DEFAULT);
          H5Awrite(attribute, type, text.data());
          H5Aclose(attribute);
          H5Sclose(scalar);
          H5Tclose(type);
          H5Dclose(set);
        }
      });
      for (const bool sandboxed : {false, true}) {
        const auto opened = open_measurement(path_, {.read = {.sandboxed = sandboxed}});
        EXPECT_EQ(std::get<acquire::Record>(opened).rows.at(0).samples, kSamples) << padding << ", " << spare;
      }
    }
  }
}

TEST_F(MatLinks, ToStorageInAnotherFileAreRefused) {
  const hid_t external = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_external(external, other_.c_str(), 0, H5F_UNLIMITED);
  EXPECT_THAT(refusal([&](hid_t file) { H5Dclose(replace_accel(file, external)); }),
              AllOf(HasSubstr("in other files"), HasSubstr(path_ + ": /accel")));
  H5Pclose(external);
}

TEST_F(MatLinks, OfVirtualSetsAreRefused) {
  const std::string source = folder_.file("source.h5");
  test::Hdf5Builder(source).ramp("s", {1, kSamples});
  const hsize_t extent[] = {1, kSamples};
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE), space = H5Screate_simple(2, extent, nullptr);
  H5Pset_virtual(creation, space, source.c_str(), "/s", space);
  EXPECT_THAT(refusal([&](hid_t file) { H5Dclose(replace_accel(file, creation)); }),
              AllOf(HasSubstr("in other files"), HasSubstr("/accel")));
  H5Pclose(creation);
  H5Sclose(space);
}

TEST_F(MatLinks, ToOtherFilesAreRefused) {
  EXPECT_THAT(refusal([&](hid_t file) {
                H5Ldelete(file, "accel", H5P_DEFAULT);
                H5Lcreate_external("other.mat", "/accel", file, "accel", H5P_DEFAULT, H5P_DEFAULT);
              }),
              AllOf(HasSubstr("link to another file"), HasSubstr(path_ + ": /accel")));
}

TEST_F(MatLinks, WithinTheFileAreRefused) {
  for (const char* target : {"/force", "/nothing", "/accel"}) {
    EXPECT_THAT(refusal([&](hid_t file) {
                  H5Ldelete(file, "accel", H5P_DEFAULT);
                  H5Lcreate_soft(target, file, "accel", H5P_DEFAULT, H5P_DEFAULT);
                }),
                HasSubstr("soft link"));
  }
}

TEST_F(MatLinks, OfAnotherKindAreRefused) {
  constexpr int kOwnKind = 100;
  const H5L_class_t own{.version = H5L_LINK_CLASS_T_VERS,
                        .id = static_cast<H5L_type_t>(kOwnKind),
                        .comment = "own",
                        .create_func = nullptr,
                        .move_func = nullptr,
                        .copy_func = nullptr,
                        .trav_func = [](const char*, hid_t, const void*, size_t, hid_t, hid_t) -> hid_t { return -1; },
                        .del_func = nullptr,
                        .query_func = nullptr};
  ASSERT_GE(H5Lregister(&own), 0);
  EXPECT_THAT(refusal([&](hid_t file) {
                H5Lcreate_ud(file, "x", static_cast<H5L_type_t>(kOwnKind), "data", 4, H5P_DEFAULT, H5P_DEFAULT);
              }),
              AllOf(HasSubstr("user-defined link"), HasSubstr("/x")));
  H5Lunregister(static_cast<H5L_type_t>(kOwnKind));
}

TEST_F(MatLinks, InGroupsAreRefused) {
  EXPECT_THAT(refusal([&](hid_t file) {
                for (const char* name : {"/s", "/s/t", "/s/t/u"}) {
                  const hid_t group = H5Gcreate2(file, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
                  add_class(group, "struct");
                  H5Gclose(group);
                }
                H5Lcreate_external("other.mat", "/accel", file, "/s/t/u/accel", H5P_DEFAULT, H5P_DEFAULT);
              }),
              HasSubstr("/s/t/u/accel"));
}

// A cell that no group lists: only the array of cells refers to it.
TEST_F(MatLinks, OfCellsAreRefused) {
  const hid_t external = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_external(external, other_.c_str(), 0, H5F_UNLIMITED);
  EXPECT_THAT(refusal([&](hid_t file) {
                const hid_t cell = replace_accel(file, external), one = H5Screate(H5S_SCALAR);
                hobj_ref_t reference = 0;
                H5Rcreate(&reference, file, "accel", H5R_OBJECT, -1);
                H5Oincr_refcount(cell);
                H5Ldelete(file, "accel", H5P_DEFAULT);
                const hid_t cells =
                    H5Dcreate2(file, "cells", H5T_STD_REF_OBJ, one, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
                H5Dwrite(cells, H5T_STD_REF_OBJ, H5S_ALL, H5S_ALL, H5P_DEFAULT, &reference);
                add_class(cells, "cell");
                H5Dclose(cells);
                H5Sclose(one);
                H5Dclose(cell);
              }),
              AllOf(HasSubstr("in other files"), HasSubstr("/cells")));
  H5Pclose(external);
}

TEST_F(MatLinks, ToRegionsAreRefused) {
  EXPECT_THAT(refusal([&](hid_t file) {
                const hid_t one = H5Screate(H5S_SCALAR);
                H5Dclose(H5Dcreate2(file, "r", H5T_STD_REF_DSETREG, one, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
                H5Sclose(one);
              }),
              AllOf(HasSubstr("references to regions"), HasSubstr("/r")));
}

TEST_F(MatLinks, AreNotSearchedInDeepGroups) {
  EXPECT_THAT(refusal([&](hid_t file) {
                std::string name;
                for (int depth = 0; depth < 40; ++depth) {
                  name += "/g";
                  H5Gclose(H5Gcreate2(file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
                }
              }),
              HasSubstr("groups within groups"));
}

// Opening a pipe without a writer waits for ever.
TEST_F(MatLinks, ToPipesAreNotFollowed) {
  const std::string pipe = folder_.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  change([&](hid_t file) {
    H5Ldelete(file, "accel", H5P_DEFAULT);
    H5Lcreate_external(pipe.c_str(), "/accel", file, "accel", H5P_DEFAULT, H5P_DEFAULT);
  });
  for (const std::vector<std::string>& trust : {std::vector<std::string>{}, {"--trust-input"}}) {
    std::vector<std::string> arguments{"info", path_};
    arguments.insert(arguments.end(), trust.begin(), trust.end());
    const auto run = test::run_percuss(arguments, {.time_limit = std::chrono::seconds(30)});
    EXPECT_FALSE(run.timed_out);
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("link to another file"));
  }
}

TEST_F(MatLinks, LeadNoBytesOfAnotherFileIntoAnOutput) {
  const hid_t external = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_external(external, other_.c_str(), 0, H5F_UNLIMITED);
  change([&](hid_t file) { H5Dclose(replace_accel(file, external, H5T_STD_U8LE)); });
  H5Pclose(external);
  const std::string output = folder_.file("out.csv");
  EXPECT_EQ(test::run_percuss({"convert", path_, "-o", output}).code, 3);
  EXPECT_FALSE(std::filesystem::exists(output));
}

}  // namespace percuss::mat_links_test
