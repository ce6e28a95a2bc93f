#include "acquire/record/sampling_rate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"

namespace percuss::acquire::sampling_rate_test {

TEST(SamplingRate, IsLimitedToPlausibleRates) {
  EXPECT_EQ(checked_rate_Hz(1e-3, "x"), 1e-3);
  EXPECT_EQ(checked_rate_Hz(51200, "x"), 51200);
  for (const double fs_Hz : {0.0, -1.0, 1e10, std::nan("")})
    EXPECT_THROW(checked_rate_Hz(fs_Hz, "x"), InputError) << fs_Hz;
}

}  // namespace percuss::acquire::sampling_rate_test
