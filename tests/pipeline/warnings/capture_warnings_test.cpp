#include "pipeline/warnings/capture_warnings.hpp"

#include <gtest/gtest.h>

namespace percuss::capture_warnings_test {
namespace {

using acquire::FaultKind;

TEST(CaptureWarnings, CountTheLostSamples) {
  acquire::Record record;
  EXPECT_TRUE(pipeline::capture_warnings(record).empty());
  record.faults = {{.kind = FaultKind::gap, .row = 2, .time_s = 12.34, .value = 200},
                   {.kind = FaultKind::overrun, .row = -1, .time_s = 20, .value = 50}};
  const auto warnings = pipeline::capture_warnings(record);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].code, "capture_lost_samples");
  EXPECT_TRUE(warnings[0].message.starts_with(
      "the capture lost 250 samples per channel in 2 places, first at 12.3 s; 1 of them in a blow, which was rejected"))
      << warnings[0].message;
}

TEST(CaptureWarnings, CountWhatIsKnown) {
  acquire::Record record;
  const auto message = [&] { return pipeline::capture_warnings(record).at(0).message; };
  record.faults = {{.kind = FaultKind::overrun, .row = -1, .time_s = 20}};
  EXPECT_TRUE(message().starts_with("the capture lost an unknown number of samples in 1 place, first at 20.0 s"));
  record.faults.push_back({.kind = FaultKind::dropped, .row = -1, .time_s = 30, .value = 40});
  EXPECT_TRUE(message().starts_with("the capture lost at least 40 samples per channel in 2 places, first at 20.0 s"));
  record.faults = {{.kind = FaultKind::not_a_number, .row = 0, .time_s = 2, .value = 7}};
  EXPECT_TRUE(message().starts_with("7 captured samples are no numbers, in 1 place, first at 2.0 s"));
}

TEST(CaptureWarnings, TellOfTheClockAndOfTheEnd) {
  acquire::Record record;
  record.faults = {{.kind = FaultKind::clock_drift, .value = -4e-4},
                   {.kind = FaultKind::unplugged, .time_s = 61.5},
                   {.kind = FaultKind::resumed, .time_s = 70}};
  const auto warnings = pipeline::capture_warnings(record);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[0].code, "capture_clock");
  EXPECT_NE(warnings[0].message.find("-400 ppm"), std::string::npos);
  EXPECT_EQ(warnings[0].options, std::vector<OptionId>{"fs"});
  EXPECT_EQ(warnings[1].message, "the device was unplugged after 61.5 s");
}

}  // namespace
}  // namespace percuss::capture_warnings_test
