#include "core/io/stated_rate.hpp"

#include <gtest/gtest.h>

namespace percuss::stated_rate_test {

TEST(StatedRate, IsReadFromHeadersOfInstruments) {
  EXPECT_EQ(stated_rate_Hz("Sampling Rate(Hz),50", {}), 50);
  EXPECT_EQ(stated_rate_Hz("\"Sampling Rate(Hz)\",50,,,", {}), 50);
  EXPECT_EQ(stated_rate_Hz("fs = 25.6 kHz", {}), 25600);
  EXPECT_EQ(stated_rate_Hz("Sample rate: 51200", {.delimiter = ' '}), 51200);
  EXPECT_EQ(stated_rate_Hz("Sample rate 51.2 kHz", {.delimiter = ' '}), 51200);
  EXPECT_EQ(stated_rate_Hz("Sampling frequency,12.8,kHz", {}), 12800);
  EXPECT_EQ(stated_rate_Hz("Sampling rate (kHz): 25600 Hz", {}), 25600);
  EXPECT_EQ(stated_rate_Hz("Sampling rate (kHz): 25.6", {}), 25600);
  EXPECT_EQ(stated_rate_Hz("dt [ms];0,5", {.delimiter = ';', .decimal_comma = true}), 2000);
  EXPECT_EQ(stated_rate_Hz("Sample Interval,0.001", {}), 1000);
}

TEST(StatedRate, IsAbsentInOtherLines) {
  for (const char* line : {"", "Data Nos/CH,9120", "MEAS Time(sec),182.4", "fsync,7", "Sampling Rate(Hz),",
                           "Sampling Rate(Hz),-1", "time,force,acc", "dtype,3"}) {
    EXPECT_FALSE(stated_rate_Hz(line, {})) << line;
  }
}

}  // namespace percuss::stated_rate_test
