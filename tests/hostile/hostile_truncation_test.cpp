#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "support/files/hdf5_builder.hpp"
#include "support/files/synthetic_files.hpp"
#include "support/json.hpp"
#include "support/percuss_process.hpp"
#include "support/rejection.hpp"
#include "support/scratch_folder.hpp"

// Files that are cut off, damaged, or smaller than they claim.
namespace percuss::hostile_truncation_test {

using test::expect_reading_commands_reject;
using test::Hdf5Builder;
using test::rejection_of;
using test::run_percuss;
using testing::AnyOf;

class HostileTruncation : public testing::Test {
 protected:
  test::ScratchFolder folder_;
  std::string hdf5_ = folder_.file("cut.h5"), csv_ = folder_.file("cut.csv");
};

TEST_F(HostileTruncation, RejectsAnHdf5FileCutAnywhere) {
  const std::string whole = folder_.file("whole.h5");
  test::write_small_test(whole, R"("hits": 1)");
  const std::string bytes = test::bytes_of(whole);
  std::vector<std::size_t> cuts{
      1, 7, 8, 40, 96, 97, 512, 800, 1024, 2048, bytes.size() - 4096, bytes.size() - 8, bytes.size() - 1};
  for (std::size_t part = 1; part < 12; ++part) cuts.push_back(part * bytes.size() / 12);
  for (const std::size_t cut : cuts) {
    SCOPED_TRACE(cut);
    test::write_bytes(hdf5_, bytes.substr(0, cut));
    rejection_of({"analyze", hdf5_}, {".json", ".csv", ".h5"}, hdf5_);
    rejection_of({"info", hdf5_}, {".json"}, hdf5_);
  }
  test::write_bytes(hdf5_, bytes.substr(0, bytes.size() / 2));
  expect_reading_commands_reject(hdf5_, hdf5_);
}

// A text cut after a whole line is a shorter record. A cut within a line must be found.
TEST_F(HostileTruncation, RejectsATextCutWithinALine) {
  const std::string whole = folder_.file("whole.csv");
  test::write_small_test(whole, R"("hits": 1)");
  const std::string bytes = test::bytes_of(whole);
  for (std::size_t part = 1; part < 10; ++part) {
    const std::size_t line = bytes.find('\n', part * bytes.size() / 10) + 1;
    for (const char* text : {"0", "0,", "0,0.25", "0,0.25,", "0,0.25,1.5", "0,0.25,1.5,", "0,0.25,1.5,2.5"}) {
      test::write_bytes(csv_, bytes.substr(0, line) + text);
      rejection_of({"analyze", csv_}, {".json", ".csv", ".h5"}, csv_);
    }
  }
}

TEST_F(HostileTruncation, SurvivesATextCutAnywhere) {
  const std::string whole = folder_.file("whole.csv");
  test::write_small_test(whole, R"("hits": 1)");
  const std::string bytes = test::bytes_of(whole);
  std::mt19937 random(3);
  for (int i = 0; i < 40; ++i) {
    const std::size_t cut = i < 20 ? static_cast<std::size_t>(i) * 3 : random() % bytes.size();
    SCOPED_TRACE(cut);
    test::write_bytes(csv_, bytes.substr(0, cut));
    const auto outcome = run_percuss({"analyze", csv_, "--json"}, {.time_limit = std::chrono::seconds(20)});
    EXPECT_EQ(outcome.signal, 0);
    EXPECT_THAT(outcome.code, AnyOf(0, 3, 4)) << outcome.err;
    if (outcome.code == 3) {
      EXPECT_EQ(test::lines_of(outcome.err).size(), 1U) << outcome.err;
    } else {
      EXPECT_TRUE(nlohmann::json::accept(outcome.out));
    }
  }
}

TEST_F(HostileTruncation, SurvivesSingleBytesDamagedInHdf5) {
  const std::string whole = folder_.file("whole.h5");
  test::write_small_test(whole, R"("hits": 1)");
  const std::string bytes = test::bytes_of(whole);
  std::mt19937 random(11);
  for (int i = 0; i < 60; ++i) {
    std::string damaged = bytes;
    const std::size_t at = random() % (i % 2 == 0 ? 4096 : bytes.size());
    damaged[at] = static_cast<char>(random() & 0xFFU);
    SCOPED_TRACE(at);
    test::write_bytes(hdf5_, damaged);
    const auto outcome = run_percuss({"analyze", hdf5_, "--json"}, {.time_limit = std::chrono::seconds(20)});
    EXPECT_EQ(outcome.signal, 0);
    EXPECT_THAT(outcome.code, AnyOf(0, 3, 4)) << outcome.err;
    if (outcome.code == 3) {
      EXPECT_EQ(test::lines_of(outcome.err).size(), 1U) << outcome.err;
    }
  }
}

TEST_F(HostileTruncation, RejectsSizesBeyondTheFile) {
  const hsize_t many = 270000000;  // 10.8 GB in 5 hits
  test::Hdf5Storage contiguous, chunked;
  contiguous.written = chunked.written = false;
  chunked.chunk = {1, 4096};
  test::Hdf5Storage chunked_accel = chunked;
  chunked_accel.chunk = {1, 1, 4096};
  Hdf5Builder(hdf5_)
      .numbers("", "fs", {1000})
      .ramp("force", {5, many}, contiguous)
      .ramp("accel", {5, 1, many}, contiguous);
  expect_reading_commands_reject(hdf5_, hdf5_);
  Hdf5Builder(hdf5_)
      .numbers("", "fs", {1000})
      .ramp("force", {5, many}, chunked)
      .ramp("accel", {5, 1, many}, chunked_accel);
  expect_reading_commands_reject(hdf5_, hdf5_);
  Hdf5Builder(hdf5_)
      .numbers("", "fs", {1000})
      .ramp("force", {2, 64})
      .ramp("accel", {2, hsize_t{1} << 30, 64}, contiguous);
  expect_reading_commands_reject(hdf5_, hdf5_);
}

TEST_F(HostileTruncation, TakesNoMemoryForTheSizeThatATextClaims) {
  std::string text =
      "ID No.,PCD-400A,\nSampling Rate(Hz),1000,\nData Nos/CH,1300000000000,\nCH No.,hammer_N,acc\nUnit,N,m/s2\n";
  for (int i = 0; i < 400; ++i) text += std::to_string(i / 1000.0) + (i >= 100 && i < 104 ? ",50,8\n" : ",0.01,0.1\n");
  test::write_bytes(csv_, text);
  const auto outcome = run_percuss({"info", csv_}, {.time_limit = std::chrono::seconds(20)});
  EXPECT_THAT(outcome.code, AnyOf(0, 3)) << outcome.err;
  EXPECT_LT(outcome.peak_bytes, std::size_t{1} << 30U);
}

}  // namespace percuss::hostile_truncation_test
