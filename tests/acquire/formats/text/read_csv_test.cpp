#include "acquire/formats/text/read_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.hpp"
#include "support/files/csv_text.hpp"
#include "support/input_error.hpp"
#include "support/messages.hpp"
#include "support/record_samples.hpp"

namespace percuss::acquire::read_csv_test {

using test::accel_mps2;
using test::csv_record;
using test::force_N;
using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(ReadCsv, DescribesARecordAndReadsItInSI) {
  const Record record = csv_record("\xEF\xBB\xBFtime_s,force_lbf,acc_g\r\n0,1,2\r\n0.001,3,4\r\n0.002,5,6\r\n");
  EXPECT_EQ(record.format, "CSV");
  EXPECT_EQ(record.fs_Hz, 1000);
  EXPECT_EQ(record.force.name, "force_lbf");
  EXPECT_EQ(record.force.unit, "lbf");
  EXPECT_EQ(record.accel.at(0).unit, "g");
  EXPECT_THAT(record.notes, IsEmpty());
  EXPECT_EQ(force_N(record), (std::vector<double>{kPoundForce_N, 3 * kPoundForce_N, 5 * kPoundForce_N}));
  EXPECT_EQ(accel_mps2(record).at(2), 6 * kStandardGravity_mps2);
}

TEST(ReadCsv, GivesTheSameNumbersInEveryDialect) {
  for (const char* text :
       {"t_s,force_N,acc_g\n0,1.5,2\n0.5,-3.5,4\n1.0,5,6\n", "t_s;force_N;acc_g\n0;1,5;2\n0,5;-3,5;4\n1,0;5;6\n",
        "t_s\tforce_N\tacc_g\r\n0\t1.5\t2\r\n0.5\t-3.5\t4\r\n1.0\t5\t6\r\n",
        "t_s force_N acc_g\n 0.0  1.5 2\n 0.5 -3.5 4\n 1.0  5.0 6\n",
        "\"t_s\",\"force_N\",\"acc_g\"\n\"0\",\"1.5\",\"2\"\n\"0.5\",\"-3.5\",\"4\"\n\"1.0\",\"5\",\"6\"\n",
        "# made today\nt_s,force_N,acc_g\n0,+1.5,2\n0.5,-3.5,4\n# pause\n\n1.0,5D0,6\n\n",
        "time,force,acc\rs,N,g\r0,1.5,2\r0.5,-3.5,4\r1.0,5,6"}) {
    const Record record = csv_record(text);
    EXPECT_EQ(record.fs_Hz, 2) << text;
    EXPECT_THAT(force_N(record), ElementsAre(1.5, -3.5, 5)) << text;
    EXPECT_EQ(accel_mps2(record).at(1), 4 * kStandardGravity_mps2) << text;
  }
}

TEST(ReadCsv, NotesAssumedUnits) {
  const Record record = csv_record("time,force,acc\n0,1,2\n0.001,3,4\n0.002,1,2\n");
  EXPECT_THAT(test::texts(record.notes), ElementsAre(HasSubstr("force is not stated; taken as N"),
                                                     HasSubstr("acc is not stated; taken as m/s^2")));
}

TEST(ReadCsv, RefusesCommasBetweenCellsAndInNumbers) {
  std::string even = "time_s,force_N,acc_m_s2\n", uneven = even, late = even, units = "time,force,acc\ns,N,m/s2\n";
  for (int n = 0; n < 300; ++n) {
    const std::string time = "0," + std::to_string(1000 + n).substr(1);
    even += time + ",1,5,-2,25\n";
    uneven += time + (n % 3 == 0 ? ",1,5,0\n" : ",1,5,2,5\n");
    late += n < 100 ? "0,0,0\n" : time + ",1,5,-2,25\n";
    units += time + ",0,-2,25\n";
  }
  for (const std::string& text : {even, uneven, late, units}) {
    const std::string message = input_error_of([&] { csv_record(text); });
    EXPECT_THAT(message, HasSubstr("commas separate the cells and mark decimals"));
    EXPECT_THAT(message, HasSubstr("semicolons"));
  }
}

TEST(ReadCsv, TakesWholeNumbersBetweenCommas) {
  EXPECT_EQ(csv_record("time_s,force_N,acc_m_s2\n0,1,2\n1,3,4\n2,3,4\n").fs_Hz, 1);
  // Whole numbers without names of columns, and lines padded with commas.
  const ReadOptions numbered{.fs_Hz = 10, .force_channel = "2", .accel_channels = {"3"}};
  EXPECT_EQ(csv_record("Operator,Smith\n0,1,2\n1,3,4\n2,3,4\n", numbered).rows.at(0).samples, 3U);
  EXPECT_EQ(csv_record("time_s,force_N,acc_m_s2\n0,1,2,,\n1,3,4,,\n2,3,4,,\n").fs_Hz, 1);
}

TEST(ReadCsv, KeepsAForceInVoltsWithANote) {
  const std::string text = "t_s,CH2 (cm/s2),CH8 (mV)\n0,100,5\n0.1,100,5\n0.2,100,5\n";
  Record record = csv_record(text, {.force_channel = "CH8"});
  EXPECT_THAT(test::texts(record.notes), ElementsAre(HasSubstr("FRFs are per volt")));
  EXPECT_EQ(record.force.to_SI, 1e-3);
  record = csv_record(text, {.force_channel = "CH8", .force_sensitivity_V_per_N = 0.002});
  EXPECT_THAT(record.notes, IsEmpty());
  EXPECT_NEAR(force_N(record).at(0), 2.5, 1e-15);  // 5 mV / (2 mV/N), two roundings
  record = csv_record(text, {.force_channel = "CH8", .force_scale = {-0.5}});
  EXPECT_EQ(force_N(record).at(0), -2.5);
}

TEST(ReadCsv, AppliesTheChannelSetUp) {
  ReadOptions options;
  options.setup = {
      {.name = "CH1", .role = "force", .sensitivity_V_per_SI = 0.5, .unit = "V"},
      {.name = "CH2", .role = "acceleration", .sign = -1, .angle_rad = 1.5, .position_m = 0.1, .unit = "g"}};
  const Record record = csv_record("t_s,CH1,CH2\n0,1,2\n0.1,3,4\n0.2,5,6\n", options);
  EXPECT_THAT(force_N(record), ElementsAre(2, 6, 10));
  EXPECT_EQ(record.accel.at(0).to_SI, -kStandardGravity_mps2);
  EXPECT_EQ(record.accel.at(0).angle_rad, 1.5);
  EXPECT_EQ(record.accel.at(0).position_m, 0.1);
}

TEST(ReadCsv, TurnsTheResponsesToABlowAlongANegativeDirection) {
  ReadOptions options;
  options.setup = {{.name = "force_N", .sign = -1, .axis = Direction{0, 0, 1}},
                   {.name = "acc_mps2", .axis = Direction{0, 0, 1}}};
  const Record record = csv_record("t_s,force_N,acc_mps2\n0,1,2\n0.1,3,4\n0.2,5,6\n", options);
  EXPECT_THAT(force_N(record), ElementsAre(1, 3, 5));
  EXPECT_THAT(accel_mps2(record), ElementsAre(-2, -4, -6));
  EXPECT_EQ(record.force.axis, (Direction{0, 0, 1}));
}

TEST(ReadCsv, ParsesOnlyTheColumnsRead) {
  const Record record = csv_record("t_s,force_N,acc_g\n0,1,2\n0.1,3,over\n0.2,5,6\n");
  EXPECT_THAT(force_N(record), ElementsAre(1, 3, 5));
  EXPECT_THAT(input_error_of([&] { accel_mps2(record); }),
              HasSubstr("\"over\" is not a number (x.csv: line 3, column 3 (acc_g))"));
}

TEST(ReadCsv, RefusesSamplesThatOverflowWhenScaled) {
  const Record record = csv_record("t_s,force_N,acc_g\n0,1,2\n0.1,3,1e308\n0.2,5,6\n");
  EXPECT_THAT(input_error_of([&] { accel_mps2(record); }), HasSubstr("too large once scaled"));
}

TEST(ReadCsv, RefusesTextsWithoutColumnsOfNumbers) {
  for (const char* text : {"hello\nworld\n", "a,b\n", "\n\n\n", "# 1,2\n", "t_s,force_N,acc_g\n"}) {
    EXPECT_THAT(input_error_of([&] { csv_record(text); }), HasSubstr("no lines of numbers")) << text;
  }
  EXPECT_THAT(input_error_of([] { csv_record("{\"a\": 1}"); }), HasSubstr("not a record of samples, but JSON"));
  EXPECT_THAT(input_error_of([] { csv_record("1\n2\n3\n"); }), HasSubstr("no force column"));
  EXPECT_THAT(input_error_of([] { csv_record(""); }), HasSubstr("empty"));
  EXPECT_THAT(input_error_of([] { csv_record("\xEF\xBB\xBF"); }), HasSubstr("empty"));
}

TEST(ReadCsv, RefusesBytesThatAreNotText) {
  EXPECT_THAT(input_error_of([] { csv_record(std::string("\xFF\xFE\x31\0", 4)); }), HasSubstr("UTF-16"));
  EXPECT_THAT(input_error_of([] { csv_record(std::string(100, '\0')); }), HasSubstr("neither text"));
  EXPECT_THAT(input_error_of([] { csv_record("PERCUSSJ" + std::string(100, '\0')); }),
              HasSubstr("this is the journal of a recording"));
}

TEST(ReadCsv, SurvivesMutationsOfAGoodFile) {
  std::string good = "ID,7\nSampling Rate(Hz),50\nhit,t_s,force_N,acc_g\n";
  for (int hit = 0; hit < 3; ++hit) {
    for (int i = 0; i < 20; ++i) good += std::to_string(hit) + "," + std::to_string(0.02 * i) + ",1.5,-2e1\n";
  }
  static constexpr std::string_view kBytes = "0123456789,;.\t\n\r\"#-+eEdDnaif \xB2\xFF";
  std::mt19937 random(1);
  std::size_t refused = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    std::string text = good;
    for (int change = 0; change < 1 + trial % 4; ++change) {
      const std::size_t at = random() % text.size();
      if (random() % 3 == 0) {
        text.erase(at, 1 + random() % 40);
      } else {
        text[at] = kBytes[random() % kBytes.size()];
      }
      if (text.empty()) text = "x";
    }
    try {
      const Record record = csv_record(text);
      for (std::size_t row = 0; row < record.rows.size(); ++row) {
        for (const double sample : force_N(record, row)) ASSERT_TRUE(std::isfinite(sample));
        for (const double sample : accel_mps2(record, 0, row)) ASSERT_TRUE(std::isfinite(sample));
      }
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000U);  // mutations that rarely matter would test nothing
}

}  // namespace percuss::acquire::read_csv_test
