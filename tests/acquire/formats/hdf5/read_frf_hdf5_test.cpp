#include "acquire/formats/hdf5/read_frf_hdf5.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "acquire/formats/hdf5/hdf5_output.hpp"
#include "support/files/hdf5_builder.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::read_frf_hdf5_test {

using testing::HasSubstr;

// Two points, two channels, three lines. Element [p, c, k] is first_value + 10 c + 100 p + jk.
struct FrfFile {
  std::vector<double> freq_Hz{0, 0.5, 1};
  std::vector<double> point{3, 7};
  double first_value = 1;
  std::string kind = "receptance", unit = "m/N";
};

std::string written(const test::ScratchFolder& folder, const FrfFile& made) {
  std::string path = folder.file("frf.h5");
  acquire::hdf5::OutputHdf5 out(path, true);
  out.create_set("frequency_hz", std::array{made.freq_Hz.size()});
  out.write("frequency_hz", {}, 0, std::span<const double>(made.freq_Hz));
  out.create_set("frf", std::array<std::size_t, 3>{2, 2, 3}, acquire::hdf5::Stored::complex128);
  for (std::size_t p = 0; p < 2; ++p) {
    for (std::size_t c = 0; c < 2; ++c) {
      std::vector<Complex> value;
      for (std::size_t k = 0; k < 3; ++k) {
        value.emplace_back(made.first_value + 10.0 * static_cast<double>(c) + 100.0 * static_cast<double>(p),
                           static_cast<double>(k));
      }
      out.write("frf", std::array{p, c}, 0, std::span<const Complex>(value));
    }
  }
  out.create_set("point", std::array{made.point.size()}, acquire::hdf5::Stored::int32);
  out.write("point", {}, 0, std::span<const double>(made.point));
  out.set_text("", "kind", made.kind);
  out.set_text("", "unit", made.unit);
  out.set_numbers("frf", "angle_deg", std::array{0.0, 90.0}, true);
  out.commit();
  return path;
}

TEST(ReadFrfHdf5, ReadsTheDocumentedLayout) {
  const test::ScratchFolder folder;
  const auto frfs = read_frf_hdf5(written(folder, {}));
  ASSERT_TRUE(frfs);
  ASSERT_EQ(frfs->frfs.size(), 4U);
  EXPECT_EQ(frfs->frfs[3].point, 7);
  EXPECT_EQ(frfs->frfs[3].channel, 1U);
  EXPECT_EQ(frfs->frfs[3].value[2], Complex(111, 2));
  EXPECT_EQ(frfs->unit->kind, FrfKind::receptance);
  EXPECT_EQ(frfs->record.lines.df_Hz(), 0.5);
  EXPECT_NEAR(*frfs->record.accel.at(1).angle_rad, std::numbers::pi / 2, 1e-15);  // degrees in the file
}

TEST(ReadFrfHdf5, ChecksAStatedSpacing) {
  const test::ScratchFolder folder;
  const auto lines = [&](double df_Hz) {
    return to_accelerances(*read_frf_hdf5(written(folder, {})), {.read = {.df_Hz = df_Hz}}).lines;
  };
  EXPECT_EQ(lines(0.5).df_Hz(), 0.5);
  EXPECT_THAT(test::input_error_of([&] { lines(0.25); }), HasSubstr("contradicts the frequencies"));
}

TEST(ReadFrfHdf5, IgnoresTimeRecords) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("record.h5");
  test::Hdf5Builder(path).numbers("", "fs", {1000}).ramp("force", {2, 8}).ramp("accel", {2, 1, 8});
  EXPECT_FALSE(read_frf_hdf5(path));
}

TEST(ReadFrfHdf5, RefusesContradictionsAndNamesTheDataSet) {
  const test::ScratchFolder folder;
  const auto refusal = [&](const FrfFile& made) {
    const std::string path = written(folder, made);
    return test::input_error_of([&] { read_frf_hdf5(path); });
  };
  EXPECT_THAT(refusal({.freq_Hz = {0, 1}}), HasSubstr("/frequency_hz"));
  EXPECT_THAT(refusal({.freq_Hz = {0, 1, 5}}), HasSubstr("not a multiple"));
  EXPECT_THAT(refusal({.freq_Hz = {0, 1, std::nan("")}}), HasSubstr("not a finite number"));
  EXPECT_THAT(refusal({.point = {1, 1}}), HasSubstr("/point"));
  EXPECT_THAT(refusal({.point = {1}}), HasSubstr("/point"));
  EXPECT_THAT(refusal({.first_value = std::numeric_limits<double>::infinity()}), HasSubstr("/frf"));
}

TEST(ReadFrfHdf5, RefusesFrfsThatAreNotComplex) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("real.h5");
  test::Hdf5Builder(path).ramp("frf", {2, 8}).ramp("frequency_hz", {8});
  EXPECT_THAT(test::input_error_of([&] { read_frf_hdf5(path); }), HasSubstr("complex"));
}

}  // namespace percuss::acquire::read_frf_hdf5_test
