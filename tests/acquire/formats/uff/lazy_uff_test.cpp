#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>

#include "acquire/formats/uff/read_uff.hpp"
#include "acquire/formats/uff/write_uff.hpp"
#include "acquire/open_measurement.hpp"
#include "core/error.hpp"
#include "core/io/lazy_file.hpp"
#include "support/files/csv_text.hpp"
#include "support/files/uff_text.hpp"
#include "support/input_error.hpp"
#include "support/record_samples.hpp"
#include "support/scratch_folder.hpp"

// Universal files so long that their numbers stay on the disk until they are read.
namespace percuss::acquire::lazy_uff_test {

namespace fs = std::filesystem;
using test::accel_mps2;
using test::force_N;
using test::input_error_of;
using testing::HasSubstr;

constexpr std::size_t kSamples = 20000;

class LazyUff : public testing::Test {
 protected:
  LazyUff() {
    std::vector<std::vector<double>> force(3);
    std::vector<std::vector<std::vector<double>>> accel(3, std::vector<std::vector<double>>(2));
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t i = 0; i < kSamples; ++i) {
        const auto x = static_cast<double>(i * (row + 1));
        force[row].push_back(std::sin(x));
        accel[row][0].push_back(std::cos(x));
        accel[row][1].push_back(1 / (x + 1));
      }
    }
    record_ = record_in_memory(25600, force, accel);
    write_uff(path_, record_, false);
  }
  /// Opens these bytes in memory, without a file.
  Record in_memory(const std::string& bytes) const { return open_uff(test::csv_bytes(bytes)); }

  test::ScratchFolder folder_;
  std::string path_ = folder_.file("long.uff");
  Record record_;
};

TEST_F(LazyUff, GivesTheSameNumbersAsAFileInMemory) {
  const Record record = open_record(path_);
  ASSERT_EQ(record.rows.size(), 3U);
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_TRUE(force_N(record, row) == force_N(record_, row));
    for (std::size_t channel = 0; channel < 2; ++channel)
      EXPECT_TRUE(accel_mps2(record, channel, row) == accel_mps2(record_, channel, row));
  }
  std::vector<double> few(77);
  record.read_accel_mps2(2, 1, 12345, few);
  EXPECT_EQ(few[3], accel_mps2(record_, 1, 2)[12348]);
}

TEST_F(LazyUff, ReadsNumbersOfAnyKind) {
  for (const bool big : {false, true}) {
    for (const int type : {2, 4}) {
      test::UffText set{.ordinate_type = type, .values = kSamples, .ordinate = 13};
      std::string bytes;
      for (std::size_t i = 0; i < kSamples; ++i) {
        bytes += type == 2 ? test::number_bytes(static_cast<float>(i), big)
                           : test::number_bytes(static_cast<double>(i), big);
      }
      std::string text = set.binary(bytes, big ? 2 : 1, bytes.size());
      set.ordinate = 12;
      test::write_bytes(path_, text + set.binary(bytes, big ? 2 : 1, 7));  // a wrong length in its first line
      const Record record = open_record(path_);
      EXPECT_EQ(force_N(record)[kSamples - 1], kSamples - 1);
      EXPECT_EQ(accel_mps2(record)[4711], 4711);
    }
  }
}

TEST_F(LazyUff, IsRefusedWhenTruncatedLikeAFileInMemory) {
  const std::string bytes = test::bytes_of(path_);
  for (std::size_t cut = 9973; cut < bytes.size(); cut += 9973) {
    test::write_bytes(path_, bytes.substr(0, cut));
    const std::string refusal = input_error_of([&] { open_record(path_); });
    EXPECT_EQ(refusal.substr(0, refusal.find('(')), [&] {
      const std::string other = input_error_of([&] { in_memory(bytes.substr(0, cut)); });
      return other.substr(0, other.find('('));
    }()) << cut;
  }
}

TEST_F(LazyUff, RefusesALengthInRecord7ThatIsTooLarge) {
  std::string bytes = test::bytes_of(path_);
  const std::string claimed = "     20000         1";
  for (std::size_t at = bytes.find(claimed); at != std::string::npos; at = bytes.find(claimed, at + 1))
    bytes.replace(at, claimed.size(), "     20001         1");
  test::write_bytes(path_, bytes);
  EXPECT_THAT(input_error_of([&] { open_record(path_); }), HasSubstr("fewer bytes than record 7 states"));
}

TEST_F(LazyUff, ReportsAFileTruncatedMeanwhile) {
  const Record record = open_record(path_);
  fs::resize_file(path_, 100000);
  EXPECT_THAT(input_error_of([&] { force_N(record, 2); }), HasSubstr("became shorter while it was read"));
}

// A last line of 200 MB without an end. The search for its end reads every byte once.
TEST(LazyFile, TakesTimeInProportionToItsLength) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("long.unv");
  test::write_bytes(path, "    -1\n    58\n");
  fs::resize_file(path, 200'000'000);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THAT(input_error_of([&] { open_record(path); }), HasSubstr("not closed"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10)) << "a quadratic search takes 30 s";
}

TEST(LazyFile, ReadsTheRangeRequested) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("x"), "0123456789");
  LazyFile file(folder.file("x"), 100);
  ASSERT_EQ(file.size(), 10U);
  file.load(4, 6);
  EXPECT_EQ(std::string(file.data(), 10), std::string("\0\0\0\0"
                                                      "45\0\0\0\0",
                                                      10));
  file.load(8, 100);
  EXPECT_EQ(file.data()[9], '9');
  EXPECT_THAT(input_error_of([&] { LazyFile(folder.file("x"), 9); }), HasSubstr("longer than"));
  EXPECT_THAT(input_error_of([&] { LazyFile(folder.path(), 9); }), HasSubstr("folder"));
}

}  // namespace percuss::acquire::lazy_uff_test
