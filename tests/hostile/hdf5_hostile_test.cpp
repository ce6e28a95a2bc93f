#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <functional>
#include <limits>

#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "support/files/hdf5_builder.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::hdf5_hostile_test {

using test::Hdf5Builder;
using test::input_error_of;
using testing::AllOf;
using testing::HasSubstr;

using Shape = std::vector<hsize_t>;

class Hdf5Hostile : public testing::Test {
 protected:
  /// The message that rejects a valid file after `spoil` changed it. `without` omits "force", "accel" or "fs".
  std::string rejection_of(const std::function<void(Hdf5Builder&)>& spoil, const std::string& without = "",
                           const acquire::ReadOptions& options = {}) const {
    {
      Hdf5Builder file(path_);
      if (without != "fs") file.numbers("", "fs", {1000});
      if (without != "force") file.ramp("force", {2, 9});
      if (without != "accel") file.ramp("accel", {2, 2, 9});
      spoil(file);
    }
    std::string message = input_error_of([&] { acquire::open_hdf5(path_, options); });
    EXPECT_THAT(message, HasSubstr(path_));
    return message;
  }
  std::string refusal_of_shapes(const Shape& force, const Shape& accel) const {
    Hdf5Builder(path_).numbers("", "fs", {1000}).ramp("force", force).ramp("accel", accel);
    return input_error_of([&] { acquire::open_hdf5(path_); });
  }
  std::string refusal_of_bytes(const std::string& bytes) const {
    test::write_bytes(path_, bytes);
    return input_error_of([&] { acquire::open_hdf5(path_); });
  }
  /// A data set /force of two hits with the given creation property list and type, without values.
  static void declare_force(const Hdf5Builder& file, hid_t type, hid_t creation) {
    const Shape shape{2, 9};
    const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
    const hid_t set = H5Dcreate2(file.id(), "force", type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    ASSERT_GE(set, 0);
    H5Dclose(set);
    H5Sclose(space);
  }

  test::ScratchFolder folder_;
  std::string path_ = folder_.file("bad.h5");
};

TEST_F(Hdf5Hostile, RejectsOtherFiles) {
  EXPECT_THAT(refusal_of_bytes(""), HasSubstr("not an HDF5 file"));
  EXPECT_THAT(refusal_of_bytes("hit,t_s,force_N\n0,0,1\n"), HasSubstr("not an HDF5 file"));
  EXPECT_THAT(refusal_of_bytes(std::string("\x89HDF\r\n\x1a\n", 8) + std::string(100, '\0')), HasSubstr("damaged"));
  EXPECT_THAT(input_error_of([&] { acquire::open_hdf5(folder_.file("none.h5")); }), HasSubstr("No such file"));
  EXPECT_THAT(input_error_of([&] { acquire::open_hdf5(folder_.path()); }), HasSubstr("not a regular file"));
  ASSERT_EQ(::mkfifo(folder_.file("pipe").c_str(), 0600), 0);
  EXPECT_THAT(input_error_of([&] { acquire::open_hdf5(folder_.file("pipe")); }), HasSubstr("not a regular file"));
}

TEST_F(Hdf5Hostile, NamesTheObjectFoundInsteadOfADataSet) {
  const auto other = [](Hdf5Builder& file) { file.ramp("hammer", {2, 9}); };
  EXPECT_THAT(rejection_of(other, "force"), AllOf(HasSubstr("no data set /force"), HasSubstr("accel, hammer")));
  EXPECT_THAT(rejection_of(other, "accel"), AllOf(HasSubstr("no data set /accel"), HasSubstr("force, hammer")));
  const auto group = [](Hdf5Builder& file) {
    H5Gclose(H5Gcreate2(file.id(), "force", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  };
  EXPECT_THAT(rejection_of(group, "force"), HasSubstr("not a data set"));
}

TEST_F(Hdf5Hostile, RejectsShapesThatAreNotARecord) {
  EXPECT_THAT(refusal_of_shapes({}, {2, 9}), HasSubstr("[hits, samples]"));
  EXPECT_THAT(refusal_of_shapes({2, 2, 9}, {2, 2, 9}), HasSubstr("[2, 2, 9]"));
  EXPECT_THAT(refusal_of_shapes({2, 9}, {1, 2, 2, 9}), HasSubstr("4 dimensions"));
  EXPECT_THAT(refusal_of_shapes({2, 9}, {}), HasSubstr("[hits, channels, samples]"));
  EXPECT_THAT(refusal_of_shapes({0, 9}, {0, 1, 9}), HasSubstr("no hits"));
  EXPECT_THAT(refusal_of_shapes({2, 0}, {2, 1, 0}), HasSubstr("no samples"));
  EXPECT_THAT(refusal_of_shapes({2, 1}, {2, 1, 1}), HasSubstr("one sample"));
  EXPECT_THAT(refusal_of_shapes({2, 9}, {2, 0, 9}), HasSubstr("empty"));
  EXPECT_THAT(refusal_of_shapes({2, 9}, {3, 1, 9}), HasSubstr("[2, 9] and accel [3, 1, 9] disagree"));
  EXPECT_THAT(refusal_of_shapes({2, 9}, {2, 1, 8}), HasSubstr("disagree"));
  EXPECT_THAT(refusal_of_shapes({9}, {8}), HasSubstr("disagree"));
  EXPECT_THAT(refusal_of_shapes({5000, 2}, {5000, 1, 2}), HasSubstr("transposed"));
}

TEST_F(Hdf5Hostile, RejectsUnusableSamplingRates) {
  EXPECT_THAT(rejection_of([](Hdf5Builder&) {}, "fs"), HasSubstr("fs is missing"));
  for (const double fs_Hz : {0.0, -1000.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e30, 1e-30}) {
    EXPECT_THAT(rejection_of([&](Hdf5Builder& file) { file.numbers("", "fs", {fs_Hz}); }, "fs"),
                HasSubstr("not usable"));
  }
  EXPECT_THAT(rejection_of(
                  [](Hdf5Builder& file) {
                    file.numbers("", "fs", {1000, 2000});
                  },
                  "fs"),
              HasSubstr("2 numbers"));
  EXPECT_THAT(rejection_of([](Hdf5Builder& file) { file.text("", "fs", "1000"); }, "fs"), HasSubstr("not a number"));
  EXPECT_THAT(rejection_of([](Hdf5Builder& file) { file.numbers("accel", "fs", {999}); }), HasSubstr("two sampling"));
  EXPECT_THAT(test::options_of_error([&] { acquire::open_hdf5(path_, {.fs_Hz = -1}); }), testing::ElementsAre("fs"));
}

TEST_F(Hdf5Hostile, RejectsUnusableUnits) {
  const auto unit = [this](const std::string& object, const std::string& name) {
    return rejection_of([&](Hdf5Builder& file) { file.text(object, "unit_str", name); });
  };
  EXPECT_THAT(unit("force", "furlong"), AllOf(HasSubstr("furlong"), HasSubstr("/force")));
  EXPECT_THAT(unit("accel", "N"), HasSubstr("/accel"));
  EXPECT_THAT(unit("accel", "mV"), HasSubstr("sensitivity"));
  EXPECT_THAT(unit("accel", std::string(50'000, 'x')), HasSubstr("/accel"));
  EXPECT_THAT(rejection_of([](Hdf5Builder& file) { file.numbers("accel", "unit_str", {1}); }), HasSubstr("not a text"));
}

TEST_F(Hdf5Hostile, RejectsNumbersThatDoNotMatchTheHits) {
  const auto refusal = [this](const std::string& name, const Shape& shape, const std::vector<double>& values) {
    return rejection_of([&](Hdf5Builder& file) { file.values(name, shape, values); });
  };
  EXPECT_THAT(refusal("point", {3}, {0, 1, 2}), AllOf(HasSubstr("/point"), HasSubstr("[3] for 2 hits")));
  EXPECT_THAT(refusal("run", {2, 1}, {0, 1}), HasSubstr("/run"));
  EXPECT_THAT(refusal("point", {2}, {0, 0.5}), HasSubstr("entry 1"));
  EXPECT_THAT(refusal("point", {2}, {1e12, 0}), HasSubstr("entry 0"));
  EXPECT_THAT(refusal("point", {2}, {0, std::nan("")}), HasSubstr("entry 1"));
  EXPECT_THAT(refusal("geometry", {2, 4}, std::vector<double>(8)), HasSubstr("/geometry"));
  EXPECT_THAT(refusal("geometry", {3}, {0, 0, 0}), HasSubstr("[points, 2 or 3]"));
  EXPECT_THAT(refusal("geometry", {1, 2}, {0, -HUGE_VAL}), HasSubstr("infinite"));
  for (const char* name : {"angle_deg", "position_m"}) {
    EXPECT_THAT(rejection_of([&](Hdf5Builder& file) {
                  file.numbers("accel", name, {0, 1, 2});
                }),
                AllOf(HasSubstr(name), HasSubstr("3 numbers for 2 channels")));
  }
}

TEST_F(Hdf5Hostile, RejectsSizesBeyondTheFile) {
  constexpr hsize_t kHuge = 625'000'000;  // 10 GB as float64 in two hits
  const auto declared = [this](const test::Hdf5Storage& storage, const Shape& shape) {
    return rejection_of([&](Hdf5Builder& file) { file.ramp("force", shape, storage); }, "force");
  };
  EXPECT_THAT(declared({.written = false}, {2, kHuge}), HasSubstr("claims 10000000000 bytes"));
  EXPECT_THAT(declared({.written = false}, {2, 9}), HasSubstr("claims 144 bytes, the file holds 0"));
  EXPECT_THAT(declared({.written = false}, {hsize_t{1} << 62, hsize_t{1} << 62}), HasSubstr("claims"));
  EXPECT_THAT(declared({.chunk = {1, 1000}, .written = false}, {2, kHuge}), HasSubstr("claims 10000000000 bytes"));
  EXPECT_THAT(declared({.chunk = {1, 1000}, .gzip = 9, .written = false}, {2, kHuge}), HasSubstr("claims"));
}

TEST_F(Hdf5Hostile, RejectsIncompleteCompressedSets) {
  const auto first_hit_only = [](Hdf5Builder& file) {
    file.ramp("force", {2, 9}, {.chunk = {1, 9}, .gzip = 1, .written = false});
    const hid_t set = H5Dopen2(file.id(), "force", H5P_DEFAULT), space = H5Dget_space(set);
    const Shape start{0, 0}, count{1, 9};
    H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
    const hid_t memory = H5Screate_simple(2, count.data(), nullptr);
    const std::vector<double> values(9);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data());
    H5Sclose(memory);
    H5Sclose(space);
    H5Dclose(set);
  };
  EXPECT_THAT(rejection_of(first_hit_only, "force"), HasSubstr("1 of its 2 chunks"));
}

TEST_F(Hdf5Hostile, RejectsSamplesThatAreNotNumbers) {
  const auto refusal = [this](hid_t type) {
    return rejection_of([&](Hdf5Builder& file) { declare_force(file, type, H5P_DEFAULT); }, "force");
  };
  const hid_t complex = H5Tcreate(H5T_COMPOUND, 16);
  H5Tinsert(complex, "r", 0, H5T_IEEE_F64LE);
  H5Tinsert(complex, "i", 8, H5T_IEEE_F64LE);
  const hid_t varying = H5Tvlen_create(H5T_IEEE_F64LE);
  for (const hid_t type : {complex, varying, H5T_C_S1, H5T_STD_REF_OBJ, H5T_NATIVE_LDOUBLE}) {
    EXPECT_THAT(refusal(type), AllOf(HasSubstr("/force"), HasSubstr("integers or floats")));
  }
  H5Tclose(complex);
  H5Tclose(varying);
}

TEST_F(Hdf5Hostile, RejectsLinksToOtherFiles) {
  const std::string other = folder_.file("other.h5");
  Hdf5Builder(other).ramp("force", {2, 9});
  const auto external = [&](Hdf5Builder& file) {
    H5Lcreate_external(other.c_str(), "/force", file.id(), "force", H5P_DEFAULT, H5P_DEFAULT);
  };
  EXPECT_THAT(rejection_of(external, "force"), HasSubstr("link to another file"));
  const auto soft_to_external = [&](Hdf5Builder& file) {
    H5Lcreate_external(other.c_str(), "/force", file.id(), "hop", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_soft("/hop", file.id(), "force", H5P_DEFAULT, H5P_DEFAULT);
  };
  EXPECT_THAT(rejection_of(soft_to_external, "force"), HasSubstr("/force"));
  const auto cycle = [](Hdf5Builder& file) {
    H5Lcreate_soft("/hop", file.id(), "force", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_soft("/force", file.id(), "hop", H5P_DEFAULT, H5P_DEFAULT);
  };
  EXPECT_THAT(rejection_of(cycle, "force"), HasSubstr("leads nowhere"));
}

// A named path may lead through a group that is a link to another file.
TEST_F(Hdf5Hostile, RejectsPathsThroughOtherFiles) {
  const std::string other = folder_.file("other.h5"), path = folder_.file("hop.h5");
  Hdf5Builder(other).ramp("force", {2, 9});
  {
    Hdf5Builder file(path);
    H5Lcreate_external(other.c_str(), "/", file.id(), "hop", H5P_DEFAULT, H5P_DEFAULT);
    file.numbers("", "fs", {1000}).ramp("accel", {2, 1, 9});
  }
  EXPECT_THAT(input_error_of([&] { acquire::open_hdf5(path, {.force_channel = "hop/force"}); }),
              HasSubstr("no data set /hop/force among: accel, hop ("));
}

TEST_F(Hdf5Hostile, RejectsStorageInOtherFilesAndUnknownFilters) {
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  const auto refuse_list = [&](hid_t list, hid_t type) {
    return rejection_of([&](Hdf5Builder& file) { declare_force(file, type, list); }, "force");
  };
  H5Pset_external(creation, "/etc/passwd", 0, H5F_UNLIMITED);
  EXPECT_THAT(refuse_list(creation, H5T_IEEE_F64LE), HasSubstr("in other files"));
  const hid_t virtual_set = H5Pcreate(H5P_DATASET_CREATE), packed = H5Pcreate(H5P_DATASET_CREATE);
  const Shape extent{2, 9};
  const hid_t space = H5Screate_simple(2, extent.data(), nullptr);
  H5Pset_virtual(virtual_set, space, "other.h5", "/force", space);
  EXPECT_THAT(refuse_list(virtual_set, H5T_IEEE_F64LE), HasSubstr("in other files"));
  H5Pset_chunk(packed, 2, extent.data());
  H5Pset_scaleoffset(packed, H5Z_SO_INT, 0);
  H5Pset_alloc_time(packed, H5D_ALLOC_TIME_EARLY);
  EXPECT_THAT(refuse_list(packed, H5T_STD_I32LE), AllOf(HasSubstr("scaleoffset"), HasSubstr("gzip")));
  for (const hid_t list : {creation, virtual_set, packed}) H5Pclose(list);
  H5Sclose(space);
}

TEST_F(Hdf5Hostile, FollowsLinksWithinTheFile) {
  {
    Hdf5Builder file(path_);
    file.numbers("", "fs", {1000}).ramp("hammer", {2, 9}).ramp("accel", {2, 2, 9});
    H5Lcreate_soft("/hammer", file.id(), "force", H5P_DEFAULT, H5P_DEFAULT);
  }
  EXPECT_EQ(acquire::open_hdf5(path_).rows.size(), 2u);
}

}  // namespace percuss::hdf5_hostile_test
