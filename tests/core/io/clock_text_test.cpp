#include "core/io/clock_text.hpp"

#include <gtest/gtest.h>

namespace percuss::clock_text_test {

constexpr double kRounding_s = 1e-10;  // of a double near 86400 s

TEST(ParseClock, ReadsTheTimeOfDay) {
  const double time_s = 7 * 3600 + 8 * 60 + 9.5;
  for (const char* text : {"07:08:09.5", "7:08:09,5", "2024-05-06 07:08:09.5", "2024-05-06T07:08:09.5Z",
                           "06.05.2024 07:08:09.5", "05/06/2024 7:08:09.5 AM", "07:08:09.5+02:00", "\"07:08:09.5\""}) {
    const auto clock = parse_clock(text);
    ASSERT_TRUE(clock) << text;
    EXPECT_NEAR(clock->time_s, time_s, kRounding_s) << text;
    EXPECT_EQ(clock->decimals, 1) << text;
  }
  EXPECT_NEAR(parse_clock("7:08:09.5 PM")->time_s, time_s + 43200, kRounding_s);
  EXPECT_NEAR(parse_clock("12:00:00 AM")->time_s, 0, kRounding_s);
  EXPECT_EQ(parse_clock("07:08:09")->decimals, 0);
}

TEST(ParseClock, RefusesOtherTexts) {
  for (const char* text :
       {"", ":", "7", "7:08", "07:61:09", "25:00:00", "x 07:08:09", "07:08:09 x", "-07:08:09", "07:08:09.",
        "07:08:0912345678901234567890", "007:08:09", "07:08:09.1234567890123456", "1:2:3:4", "\xff:\xff:\xff"}) {
    EXPECT_FALSE(parse_clock(text)) << text;
  }
}

}  // namespace percuss::clock_text_test
