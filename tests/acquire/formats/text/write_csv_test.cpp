#include "acquire/formats/text/write_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::write_csv_test {

class WriteCsv : public testing::Test {
 protected:
  std::string text_of(const Record& record) const {
    write_record_csv(path_, record, true);
    return test::bytes_of(path_);
  }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("r.csv");
};

TEST_F(WriteCsv, WritesOneLinePerSampleHitAfterHit) {
  const Record record = record_in_memory(1000, {{1, 0.1}, {-2.5, 1e300}}, {{{0, 1}, {5, 1e-9}}, {{3, 4}, {-0.0, 7}}});
  EXPECT_EQ(text_of(record),
            "hit,t_s,force_N,acc0_m_s2,acc1_m_s2\n"
            "0,0,1,0,5\n"
            "0,0.001,0.1,1,1e-09\n"
            "1,0,-2.5,3,-0\n"
            "1,0.001,1e+300,4,7\n");
}

TEST_F(WriteCsv, NamesPointAndRunWhereTheyDiffer) {
  Record record = record_in_memory(1000, {{1}, {2}}, {{{3}}, {{4}}});
  record.rows[0].run = record.rows[1].run = 5;
  EXPECT_EQ(text_of(record), "hit,t_s,force_N,acc0_m_s2\n0,0,1,3\n1,0,2,4\n");
  record.rows[1].point = 12;
  EXPECT_EQ(text_of(record), "hit,t_s,force_N,acc0_m_s2,point\n0,0,1,3,0\n1,0,2,4,12\n");
  record.rows[1].run = 6;
  EXPECT_EQ(text_of(record), "hit,t_s,force_N,acc0_m_s2,point,run\n0,0,1,3,0,5\n1,0,2,4,12,6\n");
}

TEST_F(WriteCsv, NamesAPointThatIsNotTheFirst) {
  Record record = record_in_memory(1000, {{1}}, {{{3}}});
  record.rows[0].point = 7;
  EXPECT_EQ(text_of(record), "hit,t_s,force_N,acc0_m_s2,point\n0,0,1,3,7\n");
}

TEST_F(WriteCsv, LeavesOutAForceThatWasNotRecorded) {
  Record record = record_in_memory(1000, {{0}}, {{{3}}});
  record.has_force = false;
  EXPECT_EQ(text_of(record), "hit,t_s,acc0_m_s2\n0,0,3\n");
}

TEST_F(WriteCsv, GivesBackEverySampleExactly) {
  constexpr std::size_t kSamples = 20'000;  // more than are written at once
  std::vector<double> force(kSamples), accel(kSamples);
  for (std::size_t i = 0; i < kSamples; ++i) {
    force[i] = std::sin(static_cast<double>(i)) * 1e3;
    accel[i] = std::exp(std::cos(static_cast<double>(i)) * 300);
  }
  std::istringstream lines(text_of(record_in_memory(51200, {force}, {{accel}})));
  std::string line;
  std::getline(lines, line);
  for (std::size_t i = 0; i < kSamples; ++i) {
    ASSERT_TRUE(std::getline(lines, line));
    std::array<double, 4> numbers{};
    const char* at = line.data();
    for (double& number : numbers) at = std::from_chars(at, line.data() + line.size(), number).ptr + 1;
    ASSERT_EQ(numbers, (std::array{0.0, static_cast<double>(i) / 51200, force[i], accel[i]})) << line;
  }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST_F(WriteCsv, ReplacesOnlyWhenForced) {
  const Record record = record_in_memory(1000, {{1}}, {{{3}}});
  write_record_csv(path_, record, false);
  EXPECT_THAT(test::options_of_error([&] { write_record_csv(path_, record, false); }), testing::ElementsAre("force"));
}

}  // namespace percuss::acquire::write_csv_test
