#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <array>
#include <limits>

#include "acquire/formats/hdf5/hdf5_handle.hpp"
#include "acquire/formats/hdf5/hdf5_input.hpp"
#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "support/files/hdf5_builder.hpp"
#include "support/input_error.hpp"
#include "support/record_samples.hpp"
#include "support/scratch_folder.hpp"

// Records in HDF5 with unusual shapes, types, attributes and storage.
namespace percuss::acquire::hdf5_limits_test {

using hdf5::Handle;
using test::accel_mps2;
using test::force_N;
using test::Hdf5Builder;
using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

class Hdf5Limits : public testing::Test {
 protected:
  // A record of one hit of three samples; `add` adds further objects.
  template <class Add>
  void write(Add&& add) const {
    Hdf5Builder file(path_);
    file.numbers("", "fs", {1000}).values("force", {3}, {1, 2, 3}).values("accel", {2, 3}, {4, 5, 6, 7, 8, 9});
    add(file);
  }
  // A record of one hit of three samples, whose accelerations 4, 5, 6 are stored with this type and these properties.
  void write_filtered(hid_t type, const Handle& creation) const {
    Hdf5Builder file(path_);
    file.numbers("", "fs", {1000}).values("force", {3}, {1, 2, 3});
    const hsize_t three = 3;
    const Handle space(H5Screate_simple(1, &three, nullptr));
    const Handle set(H5Dcreate2(file.id(), "accel", type, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT));
    const std::array<double, 3> values{4, 5, 6};
    ASSERT_GE(H5Dwrite(set.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  }
  std::string refusal() const {
    return input_error_of([&] {
      const Record record = open_hdf5(path_);
      force_N(record);
      accel_mps2(record);
    });
  }
  template <class Add>
  std::string refusal_with(Add&& add) const {
    write(add);
    return refusal();
  }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("r.h5");
};

/// Properties of a data set in chunks of three samples, still without filters.
Handle chunks_of_three() {
  Handle creation(H5Pcreate(H5P_DATASET_CREATE));
  const hsize_t three = 3;
  H5Pset_chunk(creation.get(), 1, &three);
  return creation;
}

// A chunked data set of doubles with the gzip filter. The caller writes the stored bytes of its chunks.
Handle chunked(hid_t file, const char* name, const std::vector<hsize_t>& shape, const std::vector<hsize_t>& chunk) {
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_chunk(creation.get(), static_cast<int>(chunk.size()), chunk.data());
  H5Pset_deflate(creation.get(), 1);
  const std::vector<hsize_t> most(shape.size(), H5S_UNLIMITED);
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), most.data()));
  return Handle(H5Dcreate2(file, name, H5T_IEEE_F64LE, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT));
}

void write_chunk(const Handle& set, std::vector<hsize_t> at, const std::string& stored) {
  ASSERT_GE(H5Dwrite_chunk(set.get(), H5P_DEFAULT, 0, at.data(), stored.size(), stored.data()), 0);
}

void add_attribute(hid_t object, const char* name, hid_t type, const Handle& space, const void* value) {
  const Handle attribute(H5Acreate2(object, name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT));
  ASSERT_TRUE(attribute);
  if (value == nullptr) return;
  ASSERT_GE(H5Awrite(attribute.get(), type, value), 0);
}

TEST_F(Hdf5Limits, FilesThatCannotBeOpenedAreNamed) {
  EXPECT_THAT(input_error_of([&] { open_hdf5(folder_.file("none.h5")); }), HasSubstr("check the name"));
  EXPECT_THAT(input_error_of([&] { open_hdf5(folder_.path()); }), HasSubstr("is not a regular file"));
  test::write_bytes(path_, "a text");
  EXPECT_THAT(refusal(), HasSubstr("not an HDF5 file"));
  EXPECT_FALSE(is_hdf5(folder_.file("none.h5")));
  EXPECT_FALSE(is_hdf5("/dev/zero")) << "a device that never ends";
  write([](auto&) {});
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit none{.rlim_cur = 0, .rlim_max = before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  const std::string message = refusal();
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_THAT(message, HasSubstr("raise the limit of open files (ulimit -n)"));
}

TEST_F(Hdf5Limits, TwelveNamesAreShown) {
  {
    Hdf5Builder file(path_);
    for (char name = 'a'; name <= 'n'; ++name) file.values(std::string(1, name), {1}, {0});
  }
  EXPECT_THAT(refusal(), HasSubstr("no data set /force among: a, b, c, d, e, f, g, h, i, j, k, l ("));
}

TEST_F(Hdf5Limits, ARecordMayLackTheForce) {
  const auto opened = [&](const std::vector<hsize_t>& shape) {
    const std::string path = folder_.file(std::to_string(shape.size()));
    Hdf5Builder(path).numbers("", "fs", {1000}).values("accel", shape, {1, 2, 3, 4, 5, 6, 7, 8});
    return open_hdf5(path, {.force_optional = true});
  };
  const Record three = opened({2, 2, 2});
  EXPECT_FALSE(three.has_force);
  EXPECT_FALSE(three.continuous);
  EXPECT_THAT(force_N(three), ElementsAre(0, 0));
  EXPECT_THAT(accel_mps2(three, 1, 1), ElementsAre(7, 8));
  const Record two = opened({2, 4});
  EXPECT_TRUE(two.continuous);
  EXPECT_THAT(accel_mps2(two, 1), ElementsAre(5, 6, 7, 8));
  EXPECT_THAT(accel_mps2(opened({8})), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
  Hdf5Builder(path_).numbers("", "fs", {1000}).values("force", {2}, {1, 2}).values("accel", {2}, {3, 4});
  EXPECT_TRUE(open_hdf5(path_, {.force_optional = true}).has_force);
}

TEST_F(Hdf5Limits, ContradictionsAreNamed) {
  EXPECT_THAT(refusal_with([](auto& file) { file.numbers("accel", "fs", {500}); }),
              HasSubstr("two sampling rates: 1000 and 500 Hz"));
  write([](auto& file) { file.numbers("force", "fs", {1000}).numbers("accel", "fs", {1000}); });
  EXPECT_EQ(open_hdf5(path_).fs_Hz, 1000);
  EXPECT_THAT(refusal_with([](auto& file) {
                file.numbers("accel", "angle_deg", {0, kInfinity});
              }),
              HasSubstr("attribute angle_deg is infinite"));
  write([](auto& file) { file.numbers("accel", "angle_deg", {kNaN, 180}); });
  EXPECT_FALSE(open_hdf5(path_).accel[0].angle_rad.has_value());
  Hdf5Builder(path_).numbers("", "fs", {1000}).values("force", {3}, {1, 2e30, 3}).values("accel", {3}, {1, 2, 3});
  EXPECT_THAT(refusal(), HasSubstr("sample is too large (" + path_ + ": /force[1])"));
}

TEST_F(Hdf5Limits, PlacesOfContiguousSamplesAreKnown) {
  write([](auto&) {});
  EXPECT_EQ(open_hdf5(path_).contiguous.size(), 3U);
  const auto contiguous = [&](const test::Hdf5Storage& force, const test::Hdf5Storage& accel) {
    Hdf5Builder(path_).numbers("", "fs", {1}).values("force", {2}, {1, 2}, force).values("accel", {2}, {1, 2}, accel);
    return open_hdf5(path_).contiguous.size();
  };
  EXPECT_EQ(contiguous({}, {.type = H5T_IEEE_F32LE}), 2U);
  EXPECT_EQ(contiguous({.chunk = {2}}, {}), 0U);
  EXPECT_EQ(contiguous({}, {.chunk = {2}}), 0U);
  EXPECT_EQ(contiguous({.type = H5T_STD_I16LE}, {}), 0U);
}

TEST_F(Hdf5Limits, PointsAndTraceLinesHaveTheirShapes) {
  const test::Hdf5Storage bytes{.type = H5T_STD_I8LE};
  const auto geometry = [&](const std::vector<hsize_t>& shape) {
    return refusal_with([&](auto& file) { file.ramp("geometry", shape, bytes); });
  };
  EXPECT_THAT(geometry({4}), HasSubstr("shape [4] (" + path_ + ": /geometry); store [points, 2 or 3]"));
  EXPECT_THAT(geometry({2, 4}), HasSubstr("shape [2, 4]"));
  EXPECT_THAT(geometry({1'000'001, 2}), HasSubstr("shape [1000001, 2]"));
  const auto lines = [&](const std::vector<hsize_t>& shape) {
    return refusal_with([&](auto& file) { file.ramp("trace_lines", shape, bytes); });
  };
  EXPECT_THAT(lines({4}), HasSubstr("shape [4] (" + path_ + ": /trace_lines); store [lines, 2]"));
  EXPECT_THAT(lines({2, 3}), HasSubstr("shape [2, 3]"));
  EXPECT_THAT(lines({10'000'001, 2}), HasSubstr("shape [10000001, 2]"));
}

TEST_F(Hdf5Limits, EmptySetsAreReadAndNullSetsRefused) {
  write([](auto& file) { file.ramp("geometry", {0, 3}).ramp("trace_lines", {0, 2}, {.chunk = {1, 2}, .gzip = 1}); });
  EXPECT_THAT(open_hdf5(path_).geometry, testing::IsEmpty());
  const auto null_set = [](auto& file) {
    const Handle none(H5Screate(H5S_NULL));
    Handle(H5Dcreate2(file.id(), "point", H5T_IEEE_F64LE, none.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)).close();
  };
  EXPECT_THAT(refusal_with(null_set), HasSubstr("shape of one number for 1 hit ("));
}

TEST_F(Hdf5Limits, AttributesMayBeIntegersAndBlankTexts) {
  {
    Hdf5Builder file(path_);
    file.values("force", {3}, {1, 2, 3}).values("accel", {3}, {4, 5, 6}).text("accel", "unit_str", "", true);
    const Handle scalar(H5Screate(H5S_SCALAR));
    const int rate_Hz = 250;
    add_attribute(file.id(), "fs", H5T_NATIVE_INT, scalar, &rate_Hz);
  }
  const Record record = open_hdf5(path_);
  EXPECT_EQ(record.fs_Hz, 250);
  EXPECT_EQ(record.accel[0].unit, "m/s^2");
  EXPECT_TRUE(record.accel[0].unit_assumed);
}

TEST_F(Hdf5Limits, AttributesOfAnotherKindAreRefused) {
  const auto with = [&](const char* name, hid_t type, const Handle& space, const void* value) {
    return refusal_with([&](auto& file) {
      const Handle accel(H5Oopen(file.id(), "accel", H5P_DEFAULT));
      add_attribute(accel.get(), name, type, space, value);
    });
  };
  const Handle scalar(H5Screate(H5S_SCALAR)), none(H5Screate(H5S_NULL)), varying(H5Tcopy(H5T_C_S1)),
      letters(H5Tcopy(H5T_C_S1)), long_text(H5Tcopy(H5T_C_S1));
  const hsize_t two = 2;
  const Handle pair(H5Screate_simple(1, &two, nullptr));
  H5Tset_size(varying.get(), H5T_VARIABLE);
  H5Tset_size(letters.get(), 1);
  H5Tset_size(long_text.get(), 5000);
  const std::array<double, 2> rates{1000, 1000};
  const std::string text(5000, 'g');
  EXPECT_THAT(with("fs", letters.get(), scalar, text.data()), HasSubstr("attribute fs is not a number"));
  EXPECT_THAT(with("fs", H5T_NATIVE_DOUBLE, none, nullptr), HasSubstr("attribute fs holds 0 numbers"));
  EXPECT_THAT(with("fs", H5T_NATIVE_DOUBLE, pair, rates.data()), HasSubstr("attribute fs holds 2 numbers"));
  const std::string refused = "attribute unit_str is not a text";
  EXPECT_THAT(with("unit_str", H5T_NATIVE_DOUBLE, scalar, rates.data()), HasSubstr(refused));
  EXPECT_THAT(with("unit_str", letters.get(), pair, text.data()), HasSubstr(refused));
  EXPECT_THAT(with("unit_str", varying.get(), scalar, nullptr), HasSubstr(refused)) << "a text that was never written";
  EXPECT_THAT(with("unit_str", long_text.get(), scalar, text.data()), HasSubstr(refused));
}

TEST_F(Hdf5Limits, ChecksumsAndShufflingAreRead) {
  const Handle filters = chunks_of_three();
  H5Pset_shuffle(filters.get());
  H5Pset_deflate(filters.get(), 1);
  H5Pset_fletcher32(filters.get());
  write_filtered(H5T_IEEE_F64LE, filters);
  EXPECT_THAT(accel_mps2(open_hdf5(path_)), ElementsAre(4, 5, 6));
}

TEST_F(Hdf5Limits, OtherFiltersAreRefused) {
  const Handle filters = chunks_of_three();
  H5Pset_nbit(filters.get());
  write_filtered(H5T_STD_I32LE, filters);
  EXPECT_THAT(refusal(), HasSubstr("compressed with filter 5 (nbit)"));
}

TEST_F(Hdf5Limits, ChunksMustBePresentAndFit) {
  const auto with_force = [&](auto&& add) {
    {
      Hdf5Builder file(path_);
      file.numbers("", "fs", {1000}).values("accel", {4}, {1, 2, 3, 4});
      add(file.id());
    }
    return refusal();
  };
  const std::string garbage(20, 'x');
  EXPECT_THAT(with_force([&](hid_t file) { write_chunk(chunked(file, "force", {4}, {2}), {0}, garbage); }),
              HasSubstr("holds 1 of its 2 chunks"));
  EXPECT_THAT(with_force([&](hid_t file) { write_chunk(chunked(file, "force", {4}, {4}), {0}, garbage); }),
              HasSubstr("cannot be read: damaged (" + path_ + ": /force)"));
  EXPECT_THAT(with_force([&](hid_t file) { write_chunk(chunked(file, "force", {4}, {1U << 24U}), {0}, garbage); }),
              HasSubstr("claims chunks larger than the file"));
  EXPECT_THAT(with_force([&](hid_t file) { chunked(file, "force", {4}, {2}); }), HasSubstr("claims 32 bytes"));
  EXPECT_THAT(refusal_with([&](auto& file) {
                write_chunk(chunked(file.id(), "geometry", {2, 2}, {2, 2}), {0, 0}, garbage);
              }),
              HasSubstr("cannot be read: damaged (" + path_ + ": /geometry)"));
}

TEST_F(Hdf5Limits, ManyChunksAreNotCounted) {
  constexpr hsize_t kSamples = 200'001;  // chunks of one sample: one more than the reader counts
  {
    Hdf5Builder file(path_);
    file.numbers("", "fs", {1000}).ramp("accel", {kSamples}).ramp("force", {kSamples}, {.chunk = {1}});
  }
  const Record record = open_hdf5(path_);
  std::vector<double> last(1);
  record.read_force_N(0, kSamples - 1, last);
  EXPECT_EQ(last[0], test::ramp_value(kSamples - 1));
}

TEST_F(Hdf5Limits, SamplesInOtherFilesAreRefused) {
  const hsize_t three = 3;
  const auto with = [&](auto&& set_source) {
    {
      Hdf5Builder file(path_);
      file.numbers("", "fs", {1000}).values("accel", {3}, {1, 2, 3});
      const Handle creation(H5Pcreate(H5P_DATASET_CREATE)), space(H5Screate_simple(1, &three, nullptr));
      set_source(creation.get(), space.get());
      const Handle set(
          H5Dcreate2(file.id(), "force", H5T_IEEE_F64LE, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT));
      ASSERT_TRUE(set);
    }
    EXPECT_THAT(refusal(), HasSubstr("its samples are in other files (" + path_ + ": /force)"));
  };
  with([](hid_t creation, hid_t space) { H5Pset_virtual(creation, space, "other.h5", "force", space); });
  with([](hid_t creation, hid_t) { H5Pset_external(creation, "other.raw", 0, 24); });
  {
    const hdf5::Lock lock;
    const hdf5::InputHdf5 file(path_);
    EXPECT_THAT(input_error_of([&] { hdf5::InputDataSet set(file, "none"); }),
                HasSubstr("damaged, or a link that leads nowhere in this file (" + path_ + ": /none)"));
  }
}

}  // namespace percuss::acquire::hdf5_limits_test
