#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "core/error.hpp"
#include "support/files/hdf5_builder.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::hdf5_damage_test {

using test::Hdf5Builder;

class Hdf5Damage : public testing::Test {
 protected:
  Hdf5Damage() {
    Hdf5Builder(path_)
        .numbers("", "fs", {1000})
        .ramp("force", {2, 200})
        .ramp("accel", {2, 2, 200}, {.chunk = {1, 1, 64}, .gzip = 6})
        .text("force", "unit_str", "N")
        .text("accel", "unit_str", "g", true)
        .numbers("accel", "angle_deg", {0, 90})
        .values("point", {2}, {3, 4}, {.type = H5T_STD_I32LE});
    good_ = test::bytes_of(path_);
  }
  /// Reads everything. The result must be a record or an InputError for any bytes.
  bool readable(const std::string& bytes) const {
    test::write_bytes(path_, bytes);
    try {
      const acquire::Record record = acquire::open_hdf5(path_);
      std::vector<double> samples(record.rows.at(0).samples);
      for (std::size_t row = 0; row < record.rows.size(); ++row) {
        record.read_force_N(row, 0, samples);
        for (std::size_t c = 0; c < record.accel.size(); ++c) record.read_accel_mps2(row, c, 0, samples);
      }
      return true;
    } catch (const InputError&) {
      return false;
    }
  }

  test::ScratchFolder folder_;
  std::string path_ = folder_.file("r.h5");
  std::string good_;
};

TEST_F(Hdf5Damage, IsReadableToBeginWith) { EXPECT_TRUE(readable(good_)); }

TEST_F(Hdf5Damage, ByTruncationIsAlwaysAnInputError) {
  constexpr std::size_t kStep_bytes = 41;
  for (std::size_t bytes = 0; bytes < good_.size(); bytes += kStep_bytes) {
    EXPECT_FALSE(readable(good_.substr(0, bytes))) << bytes;
  }
  EXPECT_FALSE(readable(good_.substr(0, good_.size() - 1)));
}

TEST_F(Hdf5Damage, OfCompressedSamplesIsAnInputErrorWhenRead) {
  // Overwrites bytes of a compressed chunk, after its zlib header.
  std::string bytes = good_;
  const std::size_t gzip = bytes.find("\x78\x9c");
  ASSERT_NE(gzip, std::string::npos);
  bytes.replace(gzip + 2, 8, 8, '\xff');
  test::write_bytes(path_, bytes);
  const acquire::Record record = acquire::open_hdf5(path_);
  std::vector<double> samples(200);
  EXPECT_THAT(test::input_error_of([&] {
                for (std::size_t row = 0; row < 2; ++row) {
                  for (std::size_t c = 0; c < 2; ++c) record.read_accel_mps2(row, c, 0, samples);
                }
              }),
              testing::HasSubstr("/accel"));
}

TEST_F(Hdf5Damage, OfThePositionOfTheSamplesIsAnInputError) {
  Hdf5Builder(path_).numbers("", "fs", {1000}).ramp("force", {2, 200}).ramp("accel", {2, 1, 200});
  std::string bytes = test::bytes_of(path_);
  const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), set = H5Dopen2(file, "force", H5P_DEFAULT);
  const std::uint64_t place = H5Dget_offset(set), beyond = bytes.size() - 8;
  H5Dclose(set);
  H5Fclose(file);
  const std::size_t at = bytes.find(std::string(reinterpret_cast<const char*>(&place), sizeof place));
  ASSERT_NE(at, std::string::npos);
  std::memcpy(&bytes[at], &beyond, sizeof beyond);
  test::write_bytes(path_, bytes);
  EXPECT_THAT(test::input_error_of([&] { acquire::open_hdf5(path_); }), testing::HasSubstr("/force"));
}

}  // namespace percuss::hdf5_damage_test
