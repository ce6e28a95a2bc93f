#include "acquire/formats/text/csv_rows.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "acquire/record/sample_gap.hpp"
#include "support/files/csv_text.hpp"
#include "support/input_error.hpp"
#include "support/messages.hpp"
#include "support/record_samples.hpp"

namespace percuss::acquire::csv_rows_test {

using test::csv_record;
using test::input_error_of;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string lines_at(const std::string& head, double step, int count, const std::string& tail) {
  std::string text = head;
  for (int i = 0; i < count; ++i) text += std::to_string(step * i) + tail;
  return text;
}

TEST(CsvRows, AreHits) {
  const Record record = csv_record("hit,t_s,force_N,acc_g\n0,0,1,2\n0,0.1,3,4\n0,0.2,5,6\n3,0,7,8\n3,0.1,9,10\n");
  ASSERT_EQ(record.rows.size(), 2U);
  EXPECT_EQ(record.rows[0].samples, 3U);
  EXPECT_EQ(record.rows[1].samples, 2U);
  EXPECT_THAT(test::force_N(record, 1), ElementsAre(7, 9));
  EXPECT_EQ(record.fs_Hz, 10);
}

TEST(CsvRows, CarryPointAndRun) {
  const Record record = csv_record(
      "run,point,hit,t_s,force_N,acc_g\n0,5,0,0,1,2\n0,5,0,0.1,3,4\n0,6,0,0,5,6\n0,6,0,0.1,7,8\n1,6,0,0,9,8\n1,6,0,0.1,"
      "7,8\n");
  ASSERT_EQ(record.rows.size(), 3U);
  EXPECT_EQ(record.rows[0].point, 5);
  EXPECT_EQ(record.rows[1].point, 6);
  EXPECT_EQ(record.rows[1].run, 0);
  EXPECT_EQ(record.rows[2].run, 1);
}

TEST(CsvRows, RefuseAHitThatReturnsAfterAnother) {
  EXPECT_THAT(input_error_of(
                  [] { csv_record("hit,t_s,force_N,acc_g\n0,0,1,2\n0,1,1,2\n1,0,1,2\n1,1,1,2\n0,0,1,2\n0,1,1,2\n"); }),
              HasSubstr("hit 0 occurs again after another hit (x.csv: line 6)"));
}

TEST(CsvRows, RefuseNumbersOfHitsThatAreNotWhole) {
  for (const char* hit : {"0.5", "", "nan", "1e12", "x"}) {
    const std::string text =
        std::string("hit,t_s,force_N,acc_g\n0,0,1,2\n0,0.1,1,2\n") + hit + ",0,1,2\n1,0,1,2\n1,0.1,1,2\n1,0.2,1,2\n";
    EXPECT_THAT(input_error_of([&] { csv_record(text); }), HasSubstr("is not a whole number (x.csv: line 4, column 1"))
        << hit;
  }
}

TEST(CsvRows, RefuseNegativePoints) {
  EXPECT_THAT(input_error_of([] { csv_record("point,t_s,force_N,acc_g\n0,0,1,2\n0,0.1,1,2\n-5,0,1,2\n-5,0.1,1,2\n"); }),
              HasSubstr("-5 is not a point number (x.csv: line 4, column 1"));
  EXPECT_EQ(csv_record("run,t_s,force_N,acc_g\n-5,0,1,2\n-5,0.1,1,2\n").rows[0].run, -5);
}

TEST(CsvRows, RefuseARowOfOneSample) {
  EXPECT_THAT(input_error_of([] { csv_record("hit,t_s,force_N,acc_g\n0,0,1,2\n0,0.1,1,2\n1,0,1,2\n"); }),
              HasSubstr("fewer than two samples (x.csv: line 4)"));
}

TEST(CsvRate, IsTheUsersRateBeforeTheFiles) {
  EXPECT_EQ(csv_record("t_s,force_N,acc_g\n0,1,2\n0.1,1,2\n7,1,2\n", {.fs_Hz = 25600}).fs_Hz, 25600);
  for (const double fs_Hz :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e12}) {
    EXPECT_THAT(test::options_of_error([&] { csv_record("force_N,acc_g\n1,2\n1,2\n", {.fs_Hz = fs_Hz}); }),
                ElementsAre("fs"))
        << fs_Hz;
  }
}

TEST(CsvRate, ComesFromTheTimeInItsUnit) {
  EXPECT_EQ(csv_record("Time (ms),force_N,acc_g\n0,1,2\n0.5,1,2\n1.0,1,2\n").fs_Hz, 2000);
  EXPECT_EQ(csv_record("time_us,force_N,acc_g\n100,1,2\n110,1,2\n120,1,2\n").fs_Hz, 100000);
}

TEST(CsvRate, ComesFromTheHeaderWithoutATimeColumn) {
  const Record record = csv_record("Sampling Rate(Hz),50\nforce_N,acc_g\n1,2\n1,2\n");
  EXPECT_EQ(record.fs_Hz, 50);
  EXPECT_THAT(record.notes, IsEmpty());
}

TEST(CsvRate, NamesBothRatesThatDisagree) {
  const std::string text = lines_at("Sampling Rate(Hz),50\nt_s,force_N,acc_g\n", 0.01, 100, ",1,2\n");
  const std::string message = input_error_of([&] { csv_record(text); });
  EXPECT_THAT(message, HasSubstr("50 Hz by \"Sampling Rate(Hz),50\""));
  EXPECT_THAT(message, HasSubstr("100 Hz by the column t_s"));
  EXPECT_EQ(csv_record(text, {.fs_Hz = 50}).fs_Hz, 50);
}

TEST(CsvRate, HasARemedyWhenItIsMissing) {
  EXPECT_THAT(input_error_of([] { csv_record("force_N,acc_g\n1,2\n1,2\n"); }), HasSubstr("no sampling rate"));
  EXPECT_THAT(input_error_of([] { csv_record("sample,force_N,acc_g\n0,1,2\n1,1,2\n2,1,2\n"); }),
              HasSubstr("state it in Hz"));
  EXPECT_THAT(input_error_of([] { csv_record("CH No.,force_N,acc_g\n0,1,2\n1,1,2\n2,1,2\n"); }),
              HasSubstr("state it in Hz"));
}

TEST(CsvRate, TakesAFirstColumnThatRisesEvenlyAsTimeWithANote) {
  const Record record = csv_record("CH No.,force_N,acc_g\n0,1,2\n0.02,1,2\n0.04,1,2\n");
  EXPECT_EQ(record.fs_Hz, 50);
  EXPECT_THAT(test::texts(record.notes), ElementsAre(HasSubstr("CH No.")));
}

TEST(CsvRate, AsksForTheUnitWhereSecondsGiveALowRate) {
  const std::string text = lines_at("Time,force_N,acc_g\n", 0.0390625, 20, ",1,2\n");  // 25600 Hz in ms
  EXPECT_THAT(
      input_error_of([&] { csv_record(text); }),
      AllOf(HasSubstr("25.6 Hz if they are seconds and 25600 Hz if they are milliseconds"), HasSubstr("Time (ms)")));
  EXPECT_THAT(test::options_of_error([&] { csv_record(text); }), ElementsAre("fs"));
  // The times have six decimals.
  EXPECT_NEAR(csv_record(lines_at("Time (ms),force_N,acc_g\n", 0.0390625, 20, ",1,2\n")).fs_Hz, 25600, 1);
  EXPECT_EQ(csv_record(lines_at("Time,force_N,acc_g\n", 0.001, 20, ",1,2\n")).fs_Hz, 1000);
}

TEST(CsvRate, NamesTheLineWhereTimeIsUneven) {
  const auto uneven = [] { csv_record("t_s,force_N,acc_g\n0,1,2\n0.1,1,2\n0.2,1,2\n0.4,1,2\n0.5,1,2\n0.6,1,2\n"); };
  EXPECT_THAT(input_error_of(uneven),
              AllOf(HasSubstr("uneven time: a step of 0.2 s where 0.1 s is usual (x.csv: line 5, column 1 (t_s))"),
                    HasSubstr("samples seem lost")));
  EXPECT_THAT(test::options_of_error(uneven), IsEmpty()) << "a stated rate would shift the samples behind the gap";
  EXPECT_THAT(input_error_of([] { csv_record("t_s,force_N,acc_g\n0,1,2\n0.11,1,2\n0.2,1,2\n0.32,1,2\n0.4,1,2\n"); }),
              HasSubstr("state the sampling rate: the time column is then not used"));
  EXPECT_THAT(input_error_of([] { csv_record("t_s,force_N,acc_g\n0,1,2\n,1,2\n0.2,1,2\n"); }),
              HasSubstr("the time is empty (x.csv: line 3"));
}

/// Lines 1 ms apart with forces 0, 1, 2, … and accelerations 0, −1, −2, …, without the lines in `lost`.
std::string lines_without(const std::vector<int>& lost) {
  std::string text = "t_s,force_N,acc_m_s2\n";
  for (int i = 0; i < 60; ++i) {
    if (std::find(lost.begin(), lost.end(), i) == lost.end()) text += fmt::format("{:.5f},{},{}\n", i * 1e-3, i, -i);
  }
  return text;
}

TEST(CsvGaps, KeepTheTimeOfLaterSamples) {
  for (const std::optional<double> fs_Hz : {std::optional<double>(), std::optional<double>(1000)}) {
    const Record record = csv_record(lines_without({10, 30, 31, 32}), {.fs_Hz = fs_Hz});
    EXPECT_EQ(record.fs_Hz, 1000);
    EXPECT_EQ(record.rows.at(0).samples, 60U);
    const std::vector<SampleGap> gaps = gaps_of(record);
    ASSERT_EQ(gaps.size(), 2U);
    EXPECT_EQ(gaps[0].first, 10U);
    EXPECT_EQ(gaps[0].count, 1U);
    EXPECT_EQ(gaps[1].first, 30U);
    EXPECT_EQ(gaps[1].count, 3U);
    // A straight line takes the place of the lost samples, and these signals are straight lines.
    for (std::size_t first : {0U, 10U, 11U, 31U, 40U}) {
      for (std::size_t count = 1; first + count <= 60; ++count) {
        std::vector<double> force(count), accel(count);
        record.read_force_N(0, first, force);
        record.read_accel_mps2(0, 0, first, accel);
        for (std::size_t n = 0; n < count; ++n) {
          ASSERT_NEAR(force[n], static_cast<double>(first + n), 1e-12);
          ASSERT_NEAR(accel[n], -static_cast<double>(first + n), 1e-12);
        }
      }
    }
  }
  EXPECT_THAT(gaps_of(csv_record(lines_without({}))), IsEmpty());
}

TEST(CsvGaps, BelongToTheirRow) {
  std::string text = "hit,t_s,force_N,acc_m_s2\n";
  for (int hit = 0; hit < 3; ++hit) {
    for (int i = 0; i < 40; ++i) {
      if (hit != 1 || i != 20) text += fmt::format("{},{:.5f},{},{}\n", hit, i * 1e-3, i, 2 * i);
    }
  }
  const Record record = csv_record(text);
  ASSERT_EQ(gaps_of(record).size(), 1U);
  EXPECT_EQ(gaps_of(record)[0].row, 1U);
  const Record last = select_rows(record, [](const RowInfo& row) { return row.samples > 0; });
  EXPECT_EQ(gaps_of(last).size(), 1U);
  const Record joined = join_records({record, record}, FileGrouping::hits);
  ASSERT_EQ(gaps_of(joined).size(), 2U);
  EXPECT_EQ(gaps_of(joined)[1].row, 4U);
  EXPECT_THAT(test::force_N(joined, 4), testing::SizeIs(40));
}

// Rows with times of day, `step_ms` apart, written in whole seconds or in milliseconds.
std::string clock_lines(const std::string& head, int step_ms, bool fractions) {
  std::string text = head + "Timestamp,force_N,acc_g\n";
  for (int i = 0; i < 5000; ++i) {
    const int t_ms = i * step_ms;
    text += fmt::format("07:08:{:02}{},1,2\n", t_ms / 1000, fractions ? fmt::format(".{:03}", t_ms % 1000) : "");
  }
  return text;
}

TEST(CsvRate, ComesFromTheHeaderWhereTimesOfDayAreCoarse) {
  const Record record = csv_record(clock_lines("Sampling Rate(Hz),1000\n", 1, false));
  EXPECT_EQ(record.fs_Hz, 1000);
  EXPECT_THAT(record.notes, IsEmpty());
  EXPECT_THAT(input_error_of([] { csv_record(clock_lines("", 1, false)); }), HasSubstr("x.csv: line"));
  std::string gap = clock_lines("Sampling Rate(Hz),1000\n", 1, false);
  gap.replace(gap.rfind("07:08:04"), 8, "--:--:--");
  EXPECT_EQ(csv_record(gap).fs_Hz, 1000) << "a stamp that is not used";
}

TEST(CsvRate, OfTimesOfDayMustAgreeWithTheHeader) {
  EXPECT_EQ(csv_record(clock_lines("", 2, true)).fs_Hz, 500);
  EXPECT_EQ(csv_record(clock_lines("Sampling Rate(Hz),500\n", 2, true)).fs_Hz, 500);
  EXPECT_THAT(
      input_error_of([] { csv_record(clock_lines("Sampling Rate(Hz),1000\n", 2, true)); }),
      AllOf(HasSubstr("1000 Hz by \"Sampling Rate(Hz),1000\""), HasSubstr("500 Hz by the times of day in column 1")));
}

TEST(CsvRate, OfTimesOfDayNeedsNoNameOfTheirColumn) {
  std::string text = "Sampling Rate(Hz),1000\n";
  for (int i = 0; i < 5000; ++i) text += fmt::format("2026-11-20,07:08:{:02}.{:03},1,2\n", i * 2 / 1000, i * 2 % 1000);
  ReadOptions options;
  options.force_channel = "3";
  options.accel_channels = {"4"};
  EXPECT_THAT(input_error_of([&] { csv_record(text, options); }), HasSubstr("500 Hz by the times of day in column 2"));
}

}  // namespace percuss::acquire::csv_rows_test
