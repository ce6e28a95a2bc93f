#include "acquire/record/contiguous_samples.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "acquire/open_measurement.hpp"
#include "core/units.hpp"
#include "support/files/hdf5_builder.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::contiguous_samples_test {

using test::Hdf5Builder;
using test::Hdf5Storage;

constexpr std::size_t kRows = 3, kChannels = 2, kSamples = 40000;  // a read takes several pieces of 2^14 samples

class ContiguousSamples : public testing::Test {
 protected:
  std::string file(const Hdf5Storage& storage) const {
    std::string path = folder_.file("record.h5");
    Hdf5Builder(path)
        .numbers("", "fs", {1000})
        .ramp("force", {kRows, kSamples}, storage)
        .ramp("accel", {kRows, kChannels, kSamples}, storage)
        .text("accel", "unit_str", "g");
    return path;
  }

  test::ScratchFolder folder_;
};

// Expects the samples that `file` wrote, with accelerations times `g`.
void expect_ramps(const Record& record, double g) {
  std::vector<double> force(777), accel(kSamples - 5);
  record.read_force_N(2, 33, force);
  for (std::size_t i = 0; i < force.size(); ++i) ASSERT_EQ(force[i], test::ramp_value(2 * kSamples + 33 + i));
  record.read_accel_mps2(1, 1, 5, accel);
  const std::size_t begin = (1 * kChannels + 1) * kSamples + 5;
  for (std::size_t i = 0; i < accel.size(); ++i) ASSERT_DOUBLE_EQ(accel[i], g * test::ramp_value(begin + i));
}

TEST_F(ContiguousSamples, AreReadAsTheLibraryReadsThem) {
  for (const hid_t type : {H5T_IEEE_F64LE, H5T_IEEE_F32LE, H5T_IEEE_F64BE, H5T_STD_I16LE}) {
    const bool contiguous = H5Tequal(type, H5T_IEEE_F64LE) > 0 || H5Tequal(type, H5T_IEEE_F32LE) > 0;
    for (const bool sandboxed : {false, true}) {
      const Record record = open_record(file({.type = type}), {.sandboxed = sandboxed});
      EXPECT_EQ(record.contiguous.size(), contiguous ? 1 + kChannels : 0U);
      expect_ramps(record, kStandardGravity_mps2);
    }
  }
}

TEST_F(ContiguousSamples, AreReadForTheChosenChannels) {
  const Record record = open_record(file({}), {.accel_channels = {"2"}, .accel_scale = {-3}});
  std::vector<double> accel(9);
  record.read_accel_mps2(0, 0, 4, accel);
  for (std::size_t i = 0; i < accel.size(); ++i) EXPECT_EQ(accel[i], -3 * test::ramp_value(kSamples + 4 + i));
}

TEST_F(ContiguousSamples, ExcludeChunkedSets) {
  const std::string path = folder_.file("chunks.h5");
  Hdf5Builder(path).numbers("", "fs", {1000}).ramp("force", {kSamples}).ramp("accel", {kSamples}, {.chunk = {1000}});
  const Record record = open_record(path);
  EXPECT_TRUE(record.contiguous.empty());
  std::vector<double> accel(1500);
  record.read_accel_mps2(0, 0, 300, accel);
  for (std::size_t i = 0; i < accel.size(); ++i) ASSERT_EQ(accel[i], test::ramp_value(300 + i));
}

// Samples that are not finite are read again through the HDF5 library, which states their place in the message.
TEST_F(ContiguousSamples, AreRefusedWithTheirPlaceWhenNotFinite) {
  const std::string path = folder_.file("bad.h5");
  std::vector<double> values(kSamples, 1.0);
  values[20000] = std::numeric_limits<double>::quiet_NaN();
  Hdf5Builder(path).numbers("", "fs", {1000}).values("force", {kSamples}, values).ramp("accel", {kSamples});
  for (const bool sandboxed : {false, true}) {
    const Record record = open_record(path, {.sandboxed = sandboxed});
    std::vector<double> force(kSamples);
    const std::string message = test::input_error_of([&] { record.read_force_N(0, 0, force); });
    EXPECT_THAT(message, testing::HasSubstr("not a finite number"));
    EXPECT_THAT(message, testing::HasSubstr("[20000]"));
    record.read_force_N(0, 20001, std::span(force).first(100));  // the samples after it are good
    EXPECT_EQ(force[0], 1);
  }
}

TEST_F(ContiguousSamples, AreRefusedInAFileTruncatedMeanwhile) {
  const std::string path = file({});
  const Record record = open_record(path);
  std::filesystem::resize_file(path, 4096);
  std::vector<double> accel(kSamples);
  EXPECT_THAT(test::input_error_of([&] { record.read_accel_mps2(2, 1, 0, accel); }), testing::HasSubstr("changed"));
}

}  // namespace percuss::acquire::contiguous_samples_test
