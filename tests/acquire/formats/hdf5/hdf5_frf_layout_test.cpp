#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "acquire/formats/hdf5/hdf5_handle.hpp"
#include "acquire/formats/hdf5/read_frf_hdf5.hpp"
#include "support/files/hdf5_builder.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

// Shapes and types of FRFs in HDF5, and the data sets beside them.
namespace percuss::acquire::hdf5_frf_layout_test {

using hdf5::Handle;
using test::Hdf5Builder;
using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

// The names and the number type of a complex number's members.
struct ComplexStorage {
  std::vector<std::string> members{"r", "i"};
  hid_t number = H5T_IEEE_F64LE;
};

Handle compound(const ComplexStorage& storage, hid_t number) {
  const std::size_t bytes = H5Tget_size(number);
  Handle type(H5Tcreate(H5T_COMPOUND, storage.members.size() * bytes));
  for (std::size_t m = 0; m < storage.members.size(); ++m)
    H5Tinsert(type.get(), storage.members[m].c_str(), m * bytes, number);
  return type;
}

// Adds FRFs. Element k in C order has the value k + (k + 1) j, both numbers modulo 100.
void add_frf(hid_t file, const std::vector<hsize_t>& shape, const ComplexStorage& storage = {}) {
  std::size_t count = 1;
  for (const hsize_t size : shape) count *= size;
  std::vector<double> values;
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t m = 0; m < storage.members.size(); ++m) values.push_back(static_cast<double>((k + m) % 100));
  }
  const Handle stored = compound(storage, storage.number), memory = compound(storage, H5T_NATIVE_DOUBLE);
  const Handle space(shape.empty() ? H5Screate(H5S_SCALAR)
                                   : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr));
  const Handle set(H5Dcreate2(file, "frf", stored.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  ASSERT_TRUE(set);
  if (H5Tget_class(storage.number) == H5T_STRING || count == 0) return;
  ASSERT_GE(H5Dwrite(set.get(), memory.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
}

class Hdf5FrfLayout : public testing::Test {
 protected:
  template <class Add>
  StoredFrfs read(const std::vector<hsize_t>& shape, Add&& add, const ComplexStorage& storage = {}) const {
    {
      Hdf5Builder file(path_);
      add_frf(file.id(), shape, storage);
      std::vector<double> freq_Hz(shape.empty() ? 0 : shape.back());
      std::iota(freq_Hz.begin(), freq_Hz.end(), 0);
      if (!shape.empty()) file.values("frequency_hz", {shape.back()}, freq_Hz);
      add(file);
    }
    return read_frf_hdf5(path_).value();
  }
  StoredFrfs read(const std::vector<hsize_t>& shape, const ComplexStorage& storage = {}) const {
    return read(
        shape, [](auto&) {}, storage);
  }
  std::string refusal(const std::vector<hsize_t>& shape, const ComplexStorage& storage = {}) const {
    return input_error_of([&] { read(shape, storage); });
  }
  // For FRFs of two points, two channels and two lines.
  template <class Add>
  std::string refusal_with(Add&& add) const {
    return input_error_of([&] { read({2, 2, 2}, add); });
  }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("f.h5");
};

TEST_F(Hdf5FrfLayout, MayLackPointsAndChannels) {
  const StoredFrfs one = read({2});
  ASSERT_EQ(one.frfs.size(), 1U);
  EXPECT_THAT(one.frfs[0].value, ElementsAre(Complex(0, 1), Complex(1, 2)));
  const StoredFrfs channels = read({2, 2});
  ASSERT_EQ(channels.frfs.size(), 2U);
  EXPECT_EQ(channels.frfs[1].channel, 1U);
  EXPECT_THAT(channels.frfs[1].value, ElementsAre(Complex(2, 3), Complex(3, 4)));
  const StoredFrfs points = read({2, 1, 2});
  ASSERT_EQ(points.frfs.size(), 2U);
  EXPECT_EQ(points.frfs[1].point, 1);
  EXPECT_THAT(points.frfs[1].value, ElementsAre(Complex(2, 3), Complex(3, 4)));
}

TEST_F(Hdf5FrfLayout, HasComplexNumbersOfThreeSpellings) {
  using Members = std::vector<std::string>;
  for (const Members& members : {Members{"r", "i"}, Members{"re", "im"}, Members{"real", "imag"}})
    EXPECT_EQ(read({2}, {.members = members, .number = H5T_STD_I16BE}).frfs[0].value[1], Complex(1, 2));
  for (const Members& members : {Members{"r", "j"}, Members{"re", "i"}, Members{"real", "im"}, Members{"x", "y"},
                                 Members{"r"}, Members{"r", "i", "k"}})
    EXPECT_THAT(refusal({2}, {.members = members}), HasSubstr("not an array of complex numbers"));
  const Handle letter(H5Tcopy(H5T_C_S1));
  EXPECT_THAT(refusal({2}, {.number = letter.get()}), HasSubstr("not an array of complex numbers"));
}

TEST_F(Hdf5FrfLayout, IsRefusedWhenEmptyOrTooLarge) {
  EXPECT_THAT(refusal({}), HasSubstr("empty (" + path_ + ": /frf)"));
  EXPECT_THAT(refusal({0, 2}), HasSubstr("empty (" + path_ + ": /frf)"));
  EXPECT_THAT(refusal({1'000'001, 1, 1}, {.number = H5T_STD_I8LE}), HasSubstr("more than a million FRFs"));
  add_frf(Hdf5Builder(path_).id(), {2});
  EXPECT_THAT(input_error_of([&] { read_frf_hdf5(path_); }), HasSubstr("no data set /frequency_hz"));
}

TEST_F(Hdf5FrfLayout, YieldsToARecord) {
  Hdf5Builder(path_).values("force", {2}, {1, 2});
  EXPECT_FALSE(read_frf_hdf5(path_).has_value());
  add_frf(Hdf5Builder(path_).values("force", {2}, {1, 2}).id(), {2});
  EXPECT_FALSE(read_frf_hdf5(path_).has_value());
}

TEST_F(Hdf5FrfLayout, HasStandardDeviationsAndCoherence) {
  const StoredFrfs frfs = read({2, 2, 2}, [](auto& file) {
    file.values("frf_std", {2, 2, 2}, {0, 1, 2, 3, 4, 5, 6, 7}).values("coherence", {2, 2, 2}, std::vector(8, 0.5));
    file.values("point", {2}, {5, 9}).numbers("", "averages", {3}).numbers("", "decay_per_s", {2.5});
  });
  ASSERT_EQ(frfs.frfs.size(), 4U);
  EXPECT_THAT(frfs.frfs[2].std, ElementsAre(4, 5));
  EXPECT_THAT(frfs.frfs[3].coherence, ElementsAre(0.5, 0.5));
  EXPECT_EQ(frfs.frfs[0].point, 5);
  EXPECT_EQ(frfs.frfs[3].point, 9);
  EXPECT_EQ(frfs.frfs[1].averages, 3U);
  EXPECT_EQ(frfs.record.decay_per_s, 2.5);
  EXPECT_THAT(refusal_with([](auto& file) {
                file.values("frf_std", {2, 2}, {0, 1, 2, 3});
              }),
              HasSubstr("shape [2, 2] for FRFs [2, 2, 2] (" + path_ + ": /frf_std); store one number per line"));
  EXPECT_THAT(refusal_with([](auto& file) {
                file.values("coherence", {2, 2, 2}, {0, 1, 1, 1, 1, 1, 1, kNaN});
              }),
              HasSubstr("not a finite number (" + path_ + ": /coherence)"));
}

TEST_F(Hdf5FrfLayout, RefusesPointsThatAreNoWholeNumbers) {
  for (const double number : {0.5, 2e9, -2e9, kNaN}) {
    EXPECT_THAT(refusal_with([&](auto& file) {
                  file.values("point", {2}, {0, number});
                }),
                HasSubstr("not a whole number (" + path_ + ": /point)"));
  }
  EXPECT_THAT(refusal_with([](auto& file) {
                file.values("point", {2}, {0, -5});
              }),
              HasSubstr("-5 is not a point number (" + path_ + ": /point)"));
}

TEST_F(Hdf5FrfLayout, KnowsTheSensorsThatAreStated) {
  const StoredFrfs frfs = read({2, 2, 2}, [](auto& file) {
    file.numbers("frf", "angle_deg", {180}).numbers("frf", "position_m", {kNaN, 0.25});
  });
  ASSERT_EQ(frfs.record.accel.size(), 2U);
  EXPECT_DOUBLE_EQ(frfs.record.accel[0].angle_rad.value(), std::acos(-1));
  EXPECT_FALSE(frfs.record.accel[1].angle_rad.has_value());
  EXPECT_FALSE(frfs.record.accel[0].position_m.has_value());
  EXPECT_EQ(frfs.record.accel[1].position_m, 0.25);
  const StoredFrfs others = read({2, 2, 2}, [](auto& file) {
    file.numbers("frf", "angle_deg", {kNaN, 180}).numbers("frf", "position_m", {0.5});
  });
  EXPECT_FALSE(others.record.accel[0].angle_rad.has_value());
  EXPECT_EQ(others.record.accel[0].position_m, 0.5);
  EXPECT_FALSE(others.record.accel[1].position_m.has_value());
}

TEST_F(Hdf5FrfLayout, RefusesMoreAnglesThanChannels) {
  EXPECT_EQ(refusal_with([](auto& file) {
              file.numbers("frf", "angle_deg", {0, 90, 180});
            }),
            "attribute angle_deg holds 3 numbers (" + path_ + ": /frf); store one per channel");
}

TEST_F(Hdf5FrfLayout, ChecksDecayAndAverages) {
  for (const double decay : {-1.0, kNaN, kInfinity}) {
    EXPECT_THAT(refusal_with([&](auto& file) { file.numbers("", "decay_per_s", {decay}); }),
                HasSubstr("decay_per_s is not a decay"));
  }
  for (const double count : {-1.0, 2e9, kNaN}) {
    EXPECT_EQ(read({2}, [&](auto& file) { file.numbers("", "averages", {count}); }).frfs[0].averages, 0U);
  }
}

// Replaces the FRFs of two points, two channels and two lines by zeros, with one NaN. Real part k is at place 2 k, and
// imaginary part k at 2 k + 1.
void put_nan(hid_t file, std::size_t place) {
  const Handle set(H5Dopen2(file, "frf", H5P_DEFAULT));
  const Handle memory = compound(ComplexStorage{}, H5T_NATIVE_DOUBLE);
  std::array<double, 16> values{};
  values.at(place) = kNaN;
  ASSERT_GE(H5Dwrite(set.get(), memory.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
}

TEST_F(Hdf5FrfLayout, RefusesNumbersThatAreNotFinite) {
  for (const std::size_t place : {2U, 3U}) {  // a real part, an imaginary part
    EXPECT_THAT(refusal_with([&](auto& file) { put_nan(file.id(), place); }),
                HasSubstr("not a finite number (" + path_ + ": /frf)"));
  }
}

}  // namespace percuss::acquire::hdf5_frf_layout_test
