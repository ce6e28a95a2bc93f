#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "acquire/open_measurement.hpp"
#include "pipeline/analysis.hpp"
#include "support/json.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// A record of two gigabytes: commands read only what they need and keep none of it.
namespace percuss::large_record_test {

constexpr hsize_t kSamples = 89'500'000, kHits = 9, kHitEvery = 9'900'000;
constexpr double kForce_bytes = kSamples * 8.0;
#ifdef PERCUSS_SANITIZED
constexpr std::size_t kMaxMemory_bytes = 400'000'000;  // sanitizers keep data about accesses and freed memory
#else
constexpr std::size_t kMaxMemory_bytes = 120'000'000;
#endif

/// A data set of zeros; only written values take space on the disk.
hid_t create_set(hid_t file, const char* name, const std::vector<hsize_t>& shape) {
  const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_alloc_time(creation, H5D_ALLOC_TIME_EARLY);
  H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER);
  const hid_t set = H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  H5Pclose(creation);
  H5Sclose(space);
  return set;
}

void write_at(hid_t set, const std::vector<hsize_t>& start, const std::vector<double>& values) {
  std::vector<hsize_t> count(start.size(), 1);
  count.back() = values.size();
  const hid_t there = H5Dget_space(set), here = H5Screate_simple(1, &count.back(), nullptr);
  H5Sselect_hyperslab(there, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  H5Dwrite(set, H5T_NATIVE_DOUBLE, here, there, H5P_DEFAULT, values.data());
  H5Sclose(here);
  H5Sclose(there);
}

void write_record(const std::string& path) {
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t scalar = H5Screate(H5S_SCALAR);
  const hid_t rate = H5Acreate2(file, "fs", H5T_NATIVE_DOUBLE, scalar, H5P_DEFAULT, H5P_DEFAULT);
  const double fs_Hz = 51200;
  H5Awrite(rate, H5T_NATIVE_DOUBLE, &fs_Hz);
  const hid_t force = create_set(file, "force", {kSamples}), accel = create_set(file, "accel", {2, kSamples});
  std::vector<double> pulse, decay;
  for (int i = 0; i < 20; ++i) pulse.push_back(200 * std::sin(i * std::numbers::pi / 20));
  for (int i = 0; i < 40000; ++i) decay.push_back(50 * std::exp(-i / 5000.0) * std::sin(i * 0.1));
  for (hsize_t hit = 0; hit < kHits; ++hit) {
    const hsize_t at = 5000 + hit * kHitEvery;
    write_at(force, {at}, pulse);
    for (const hsize_t channel : {hsize_t{0}, hsize_t{1}}) write_at(accel, {channel, at}, decay);
  }
  H5Dclose(force);
  H5Dclose(accel);
  H5Aclose(rate);
  H5Sclose(scalar);
  H5Fclose(file);
}

/// The bytes that this process has read so far.
double bytes_read() {
  std::ifstream io("/proc/self/io");
  std::string key;
  double value = 0;
  io >> key >> value;
  return key == "rchar:" ? value : -1;
}

class LargeRecord : public testing::Test {
 protected:
  LargeRecord() { write_record(path_); }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("two-gigabytes.h5");
};

TEST_F(LargeRecord, HitsReadOnlyTheForceAndOnlyOnce) {
  const double before = bytes_read();
  ASSERT_GE(before, 0);
  EXPECT_EQ(pipeline::Analysis(acquire::open_record(path_), {}).force_hits().size(), kHits);
  // 0.5 % more: the force around each hit is read again.
  EXPECT_LT(bytes_read() - before, 1.005 * kForce_bytes);
}

TEST_F(LargeRecord, HitsTakeLittleMemory) {
  const auto outcome = test::run_percuss({"analyze", path_, "--only", "hits", "--json"},
                                         {.environment = {"ASAN_OPTIONS=quarantine_size_mb=1"}});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(test::parse_json(outcome.out)["hits"].size(), kHits);
  EXPECT_LT(outcome.peak_bytes, kMaxMemory_bytes);
}

}  // namespace percuss::large_record_test
