#include "acquire/formats/text/csv_captures.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "acquire/record/sample_gap.hpp"
#include "support/files/csv_text.hpp"
#include "support/input_error.hpp"
#include "support/messages.hpp"
#include "support/record_samples.hpp"

namespace percuss::acquire::csv_captures_test {

using test::accel_mps2;
using test::csv_record;
using test::force_N;
using test::input_error_of;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kSamples = 40;
constexpr double kStart_s = -0.01, kStep_s = 0.001;

// One capture: a pulse at sample 10, and responses that count up from 1000 times the number of the capture.
std::string capture(int number, int samples = kSamples, double start_s = kStart_s, double step_s = kStep_s,
                    double peak_N = 100) {
  std::string text;
  for (int i = 0; i < samples; ++i) {
    const double force_N = i == 10 ? peak_N + number : i % 2 == 0 ? 0.1 : -0.1;
    text += fmt::format("{:.4f},{:.1f},{}\n", start_s + i * step_s, force_N, number * 1000 + i);
  }
  return text;
}

const std::string kHead = "Time (s),Force (N),Acc (m/s^2)\n";

std::vector<std::size_t> row_lengths(const Record& record) {
  std::vector<std::size_t> lengths;
  for (const RowInfo& row : record.rows) lengths.push_back(row.samples);
  return lengths;
}

void expect_three_captures(const Record& record) {
  ASSERT_THAT(row_lengths(record), ElementsAre(kSamples, kSamples, kSamples));
  EXPECT_NEAR(record.fs_Hz, 1000, 1e-9);
  EXPECT_TRUE(record.continuous) << "captures are searched for hits, as files of one row are";
  for (int row = 0; row < 3; ++row) {
    EXPECT_EQ(force_N(record, static_cast<std::size_t>(row)).at(10), 100 + row);
    EXPECT_EQ(accel_mps2(record, 0, static_cast<std::size_t>(row)).at(0), 1000 * row);
  }
}

TEST(CsvCaptures, StartWhereTheTimeStartsAgain) {
  const Record record = csv_record(kHead + capture(0) + capture(1) + "\n\n" + capture(2));
  expect_three_captures(record);
  EXPECT_THAT(test::texts(record.notes),
              ElementsAre("the file is read as 3 captures: the time starts again between them"));
  EXPECT_TRUE(record.notes.front().information);
}

TEST(CsvCaptures, AreTheHitsOfFilesOfTheirOwn) {
  const Record one = csv_record(kHead + capture(0) + capture(1, 30) + capture(2));
  const Record several =
      join_records({csv_record(kHead + capture(0)), csv_record(kHead + capture(1, 30)), csv_record(kHead + capture(2))},
                   FileGrouping::hits);
  EXPECT_EQ(one.fs_Hz, several.fs_Hz);
  EXPECT_EQ(one.continuous, several.continuous);
  ASSERT_EQ(row_lengths(one), row_lengths(several));
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_EQ(force_N(one, row), force_N(several, row));
    EXPECT_EQ(accel_mps2(one, 0, row), accel_mps2(several, 0, row));
    EXPECT_EQ(one.rows[row].point, several.rows[row].point);
  }
}

TEST(CsvCaptures, AreDividedAlsoAtAStatedRate) {
  const Record record = csv_record(kHead + capture(0) + capture(1) + capture(2), {.fs_Hz = 1000});
  expect_three_captures(record);
  EXPECT_EQ(record.notes.size(), 1U) << "the times of one capture agree with the rate";
}

TEST(CsvCaptures, SkipARepeatedHeader) {
  const std::string units = "Time,Force,Acc\ns,N,m/s^2\n\n", digits = "1 Time (s),2 Force (N),3 Acc (m/s^2)\n";
  for (const std::string& head : {kHead, "\n" + kHead, units, digits}) {
    const Record record = csv_record(head + capture(0) + head + capture(1) + "\n" + head + capture(2));
    expect_three_captures(record);
    EXPECT_THAT(test::texts(record.notes),
                ElementsAre("the file is read as 3 captures: the header is repeated between them"));
  }
}

TEST(CsvCaptures, StartAtARepeatedHeaderUnlessTheTimeContinues) {
  const auto at = [](int number, double start_s) { return capture(number, kSamples, start_s); };
  expect_three_captures(csv_record(kHead + at(0, 0) + kHead + at(1, 7) + kHead + at(2, 11)));
  // A header on every page of one recording.
  const Record pages = csv_record(kHead + at(0, 0) + kHead + at(1, 0.040) + kHead + at(2, 0.080));
  EXPECT_THAT(row_lengths(pages), ElementsAre(3 * kSamples));
  EXPECT_THAT(pages.notes, IsEmpty());
  // Without a column of times.
  std::string text;
  for (int hit = 0; hit < 3; ++hit) {
    text += "Force (N),Acc (m/s^2)\n";
    for (int i = 0; i < kSamples; ++i) text += fmt::format("{},{}\n", i == 10 ? 100 + hit : 0, 1000 * hit + i);
  }
  expect_three_captures(csv_record(text, {.fs_Hz = 1000}));
}

TEST(CsvCaptures, NeedNoNameOfTheTimeAndMayHaveAnIndex) {
  std::string unnamed, indexed = "Nr," + kHead, counted = "n,Force (N),Acc (m/s^2)\n", clocks = kHead;
  for (int hit = 0; hit < 3; ++hit) {
    unnamed += capture(hit);
    for (int i = 0; i < kSamples; ++i) {
      const std::string signals = fmt::format("{},{}\n", i == 10 ? 100 + hit : 0, 1000 * hit + i);
      indexed += fmt::format("{},{:.3f},{}", hit + 1, kStart_s + i * kStep_s, signals);
      counted += fmt::format("{},{}", i, signals);
      clocks += fmt::format("00:00:00.{:03},{}", i, signals);
    }
  }
  const ReadOptions roles{.force_channel = "2", .accel_channels = {"3"}};
  expect_three_captures(csv_record(unnamed, {.fs_Hz = 1000, .force_channel = "2", .accel_channels = {"3"}}));
  EXPECT_THAT(row_lengths(csv_record("t_s,a,b\n" + unnamed, roles)), ElementsAre(kSamples, kSamples, kSamples));
  expect_three_captures(csv_record(indexed));
  expect_three_captures(csv_record(counted, {.fs_Hz = 1000}));
  expect_three_captures(csv_record(clocks));
}

TEST(CsvCaptures, MayDifferInLengthAndByStepsInTheirFirstTime) {
  const Record record =
      csv_record(kHead + capture(0) + capture(1, 17) + capture(2, kSamples, kStart_s - 2 * kStep_s) + capture(3, 25));
  EXPECT_THAT(row_lengths(record), ElementsAre(kSamples, 17, kSamples, 25));
  EXPECT_EQ(accel_mps2(record, 0, 3).at(24), 3024);
}

TEST(CsvCaptures, BelongToTheirPoint) {
  std::string text = "point," + kHead;
  for (int hit = 0; hit < 4; ++hit) {
    for (int i = 0; i < kSamples; ++i)
      text += fmt::format("{},{:.3f},{},{}\n", hit / 2, i * kStep_s, i == 10 ? 100 : 0, i);
  }
  const Record record = csv_record(text);
  ASSERT_THAT(row_lengths(record), ElementsAre(kSamples, kSamples, kSamples, kSamples));
  EXPECT_EQ(record.rows[1].point, 0);
  EXPECT_EQ(record.rows[2].point, 1);
}

TEST(CsvCaptures, AreLeftToTheColumnHit) {
  std::string text = "hit," + kHead;
  for (int hit = 0; hit < 2; ++hit) {
    for (int i = 0; i < kSamples; ++i) text += fmt::format("0,{:.3f},{},1\n", i * kStep_s, i == 10 ? 100 : 0);
  }
  EXPECT_THAT(input_error_of([&] { csv_record(text); }), HasSubstr("the time does not rise"));
}

TEST(CsvCaptures, AreNotBlocksOfOneRecording) {
  std::string text = kHead;
  for (int block = 0; block < 12; ++block) text += capture(block, kSamples, 0, kStep_s, block % 4 == 0 ? 200 : 0);
  EXPECT_THAT(input_error_of([&] { csv_record(text); }), HasSubstr("the time does not rise: it changes by -0.039 s"));
  const Record record = csv_record(text, {.fs_Hz = 1000});
  EXPECT_THAT(row_lengths(record), ElementsAre(12 * kSamples));
  EXPECT_THAT(record.notes, IsEmpty()) << "times that start again state no rate of all samples";
}

TEST(CsvCaptures, DoNotStartWhereTheTimeStepsBackElsewhere) {
  const std::string text = kHead + capture(0, kSamples, 0) + capture(1, kSamples, 0.02);
  EXPECT_THAT(input_error_of([&] { csv_record(text); }),
              HasSubstr("the time does not rise: it changes by -0.019 s (x.csv: line 42, column 1"));
  EXPECT_THAT(row_lengths(csv_record(text, {.fs_Hz = 1000})), ElementsAre(2 * kSamples));
}

TEST(CsvCaptures, HaveOneRate) {
  EXPECT_THAT(input_error_of([] { csv_record(kHead + capture(0) + capture(1, kSamples, kStart_s, 0.0005)); }),
              AllOf(HasSubstr("another sampling rate: a time step of 0.0005 s where the hits before have 0.001 s"),
                    HasSubstr("x.csv: line 42, column 1"), HasSubstr("files of their own")));
}

TEST(CsvCaptures, KeepTheTimeBehindALostLine) {
  std::string lost = capture(1);
  const std::size_t at = lost.find("\n0.0050");
  lost.erase(at, lost.find("\n0.0060") - at);
  const Record record = csv_record(kHead + capture(0) + lost + capture(2));
  EXPECT_THAT(row_lengths(record), ElementsAre(kSamples, kSamples, kSamples));
  const std::vector<SampleGap> gaps = gaps_of(record);
  ASSERT_EQ(gaps.size(), 1U);
  EXPECT_EQ(gaps[0].row, 1U);
  EXPECT_EQ(gaps[0].count, 1U);
}

TEST(CsvCaptures, NameTheLineOfALoneSample) {
  EXPECT_THAT(input_error_of([] { csv_record(kHead + capture(0) + capture(1, 1)); }),
              HasSubstr("fewer than two samples (x.csv: line 42)"));
  EXPECT_THAT(input_error_of([] { csv_record(kHead + capture(0) + capture(1, 1) + capture(2)); }),
              HasSubstr("the time does not rise: it changes by 0 s (x.csv: line 43"));
  const std::string cut = kHead + capture(0) + capture(1);
  EXPECT_THAT(input_error_of([&] { csv_record(cut.substr(0, cut.rfind(','))); }),
              HasSubstr("2 columns where 3 are expected (x.csv: line 81)"));
}

TEST(CsvCaptures, SurviveMutations) {
  const std::string good = kHead + capture(0) + kHead + capture(1) + capture(2);
  static constexpr std::string_view kBytes = "0123456789,;.\t\n\r\"#-+eE \xB2\xFF";
  std::mt19937 random(1);
  std::size_t refused = 0, divided = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::string text = good;
    for (int change = 0; change < 1 + trial % 2; ++change) {
      const std::size_t at = random() % text.size();
      if (random() % 3 == 0) {
        text.erase(at, 1 + random() % 100);
      } else {
        text[at] = kBytes[random() % kBytes.size()];
      }
      if (text.empty()) text = "x";
    }
    try {
      const Record record = csv_record(text, {.fs_Hz = trial % 2 == 0 ? std::optional(1000.0) : std::nullopt});
      std::size_t samples = 0;
      for (std::size_t row = 0; row < record.rows.size(); ++row) {
        ASSERT_GE(record.rows[row].samples, 2U);
        samples += record.rows[row].samples;
        for (const double sample : force_N(record, row)) ASSERT_TRUE(std::isfinite(sample));
        for (const double sample : accel_mps2(record, 0, row)) ASSERT_TRUE(std::isfinite(sample));
      }
      EXPECT_LE(samples, 3U * kSamples + 8);
      divided += record.rows.size() > 1 ? 1U : 0U;
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 300U);  // mutations that rarely matter would test nothing
  EXPECT_GT(divided, 300U);
}

}  // namespace percuss::acquire::csv_captures_test
