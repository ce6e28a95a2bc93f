#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <filesystem>

#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "acquire/formats/hdf5/write_hdf5.hpp"
#include "core/error.hpp"
#include "support/files/hdf5_builder.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::write_hdf5_test {

using test::input_error_of;
using testing::HasSubstr;

constexpr double kAngleTolerance_rad = 1e-15;  // degrees in the file: two roundings

class Hdf5Write : public testing::Test {
 protected:
  /// A record of `rows` hits on `channels` channels. Only the first sample of the force, 0, has a short decimal form.
  static Record make_record(std::size_t rows, std::size_t channels, std::size_t samples) {
    const auto signal = [samples](double seed) {
      std::vector<double> values(samples);
      for (std::size_t i = 0; i < samples; ++i) values[i] = std::sin(seed + 0.37 * static_cast<double>(i)) * 1e3;
      return values;
    };
    std::vector<std::vector<double>> force;
    std::vector<std::vector<std::vector<double>>> accel(rows);
    for (std::size_t row = 0; row < rows; ++row) {
      force.push_back(signal(static_cast<double>(row)));
      for (std::size_t c = 0; c < channels; ++c) accel[row].push_back(signal(static_cast<double>(10 * row + c) + 0.5));
    }
    return record_in_memory(12345.678, std::move(force), std::move(accel));
  }
  static void expect_same_samples(const Record& a, const Record& b) {
    ASSERT_EQ(a.rows.size(), b.rows.size());
    ASSERT_EQ(a.accel.size(), b.accel.size());
    for (std::size_t row = 0; row < a.rows.size(); ++row) {
      ASSERT_EQ(a.rows[row].samples, b.rows[row].samples);
      std::vector<double> x(a.rows[row].samples), y = x;
      a.read_force_N(row, 0, x);
      b.read_force_N(row, 0, y);
      EXPECT_EQ(x, y);
      for (std::size_t c = 0; c < a.accel.size(); ++c) {
        a.read_accel_mps2(row, c, 0, x);
        b.read_accel_mps2(row, c, 0, y);
        EXPECT_EQ(x, y);
      }
    }
  }

  test::ScratchFolder folder_;
  std::string path_ = folder_.file("r.h5");
};

TEST_F(Hdf5Write, GivesTheSameRecordWhenRead) {
  Record record = make_record(3, 2, 100);
  record.accel[0].angle_rad = 0.1;
  record.accel[1].position_m = 0.0762;
  record.rows[1].point = 7;
  record.rows[2].run = 2;
  record.geometry = {{0, 0.5, 1}, {1, 2, 3}};
  write_hdf5(path_, record, false);
  const Record back = open_hdf5(path_);
  expect_same_samples(record, back);
  EXPECT_EQ(back.fs_Hz, record.fs_Hz);
  EXPECT_EQ(back.continuous, record.continuous);
  EXPECT_EQ(back.geometry, record.geometry);
  EXPECT_EQ(back.force.unit, "N");
  EXPECT_EQ(back.accel[1].unit, "m/s^2");
  EXPECT_LE(std::abs(back.accel[0].angle_rad.value() - 0.1), kAngleTolerance_rad);
  EXPECT_FALSE(back.accel[1].angle_rad.has_value());
  EXPECT_EQ(back.accel[1].position_m, 0.0762);
  EXPECT_EQ(back.rows[1].point, 7);
  EXPECT_EQ(back.rows[2].run, 2);
  EXPECT_THAT(back.notes, testing::IsEmpty());
}

TEST_F(Hdf5Write, KeepsLongRowsAndTheContinuousFlag) {
  constexpr std::size_t kSamples = 300'001;  // more than are copied at once
  for (const std::size_t rows : {1u, 2u}) {
    for (const bool continuous : {false, true}) {
      Record record = make_record(rows, 1, kSamples);
      record.continuous = continuous;
      write_hdf5(path_, record, true);
      const Record back = open_hdf5(path_);
      EXPECT_EQ(back.continuous, continuous);
      expect_same_samples(record, back);
    }
  }
}

TEST_F(Hdf5Write, WritesSIWhateverUnitWasRead) {
  const std::string source = folder_.file("g.h5");
  test::Hdf5Builder(source)
      .numbers("", "fs", {1000})
      .ramp("force", {2, 9}, {.type = H5T_IEEE_F32BE})
      .ramp("accel", {2, 2, 9}, {.type = H5T_STD_I16LE})
      .text("accel", "unit_str", "g");
  const Record record = open_hdf5(source, {.accel_channels = {"2"}});
  write_hdf5(path_, record, false);
  expect_same_samples(record, open_hdf5(path_));
}

TEST_F(Hdf5Write, GivesEqualBytesForEqualInput) {
  Record record = make_record(2, 2, 50);
  record.rows[1].point = 1;
  record.accel[0].angle_rad = 0.5;
  write_hdf5(path_, record, false);
  ::sleep(1);  // a time stamp in the file would differ
  write_hdf5(folder_.file("again.h5"), record, false);
  EXPECT_EQ(test::bytes_of(path_), test::bytes_of(folder_.file("again.h5")));
  write_hdf5(folder_.file("copy.h5"), open_hdf5(path_), false);
  EXPECT_EQ(test::bytes_of(path_), test::bytes_of(folder_.file("copy.h5")));
}

TEST_F(Hdf5Write, MayReplaceTheFileItReads) {
  const Record record = make_record(2, 1, 500);
  write_hdf5(path_, record, false);
  const Record back = open_hdf5(path_);
  write_hdf5(path_, back, true);
  expect_same_samples(record, open_hdf5(path_));
  expect_same_samples(record, back);  // the old file lives until the record is gone
}

TEST_F(Hdf5Write, RefusesRecordsThatTheLayoutCannotHold) {
  Record record = make_record(2, 1, 50);
  record.rows[1].samples = 49;
  EXPECT_THAT(input_error_of([&] { write_hdf5(path_, record, false); }), HasSubstr("50 and 49 samples"));
  record.rows.clear();
  EXPECT_THAT(input_error_of([&] { write_hdf5(path_, record, false); }), HasSubstr("no hits"));
  EXPECT_THAT(input_error_of([&] { write_hdf5(path_, make_record(1, 0, 50), false); }), HasSubstr("no acceleration"));
  EXPECT_THAT(folder_.names(), testing::IsEmpty());
}

TEST_F(Hdf5Write, LeavesNothingWhenTheSamplesCannotBeRead) {
  test::write_bytes(path_, "old");
  Record record = make_record(2, 1, 50);
  record.read_force_N = [](std::size_t, std::size_t, std::span<double>) -> void {
    throw InputError("damaged", "elsewhere", "repair it");
  };
  EXPECT_THAT(input_error_of([&] { write_hdf5(path_, record, true); }), HasSubstr("elsewhere"));
  EXPECT_EQ(test::bytes_of(path_), "old");
  EXPECT_THAT(folder_.names(), testing::ElementsAre("r.h5"));
}

TEST_F(Hdf5Write, LeavesTheOldFileWhenKilledAndTheNextWriterCleansUp) {
  test::write_bytes(path_, "old");
  const pid_t child = ::fork();
  if (child == 0) {
    Record record = make_record(2, 1, 50);
    record.read_accel_mps2 = [](std::size_t row, std::size_t, std::size_t, std::span<double>) -> void {
      if (row == 1) ::kill(::getpid(), SIGKILL);
    };
    write_hdf5(path_, record, true);
    ::_exit(1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(test::bytes_of(path_), "old");
  write_hdf5(path_, make_record(2, 1, 50), true);
  EXPECT_THAT(folder_.names(), testing::ElementsAre("r.h5"));
}

/// Runs in a separate process, because it limits the size of every file that the process writes. The limit stands in
/// for a full disk.
[[noreturn]] void fill_the_disk(const std::string& path, const Record& large, const Record& small) {
  const rlimit limit{.rlim_cur = 16'384, .rlim_max = 16'384};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  ::signal(SIGXFSZ, SIG_IGN);
  int code = 1;
  try {
    write_hdf5(path, large, false);
  } catch (const InputError&) {
    write_hdf5(path, small, false);  // the library still works
    code = open_hdf5(path).rows.size() == small.rows.size() ? 3 : 2;
  }
  std::exit(code);  // NOLINT(concurrency-mt-unsafe): runs the exit handlers
}

TEST_F(Hdf5Write, SurvivesAFullDisk) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(fill_the_disk(path_, make_record(2, 1, 5000), make_record(2, 1, 5)), testing::ExitedWithCode(3), "");
}

}  // namespace percuss::acquire::write_hdf5_test
