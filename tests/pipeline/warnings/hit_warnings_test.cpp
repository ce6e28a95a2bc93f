#include "pipeline/warnings/hit_warnings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace percuss::pipeline::hit_warnings_test {

bool warns(double peak_N, const std::string& code) {
  std::vector<AnalysedHit> hits;
  for (const double factor : {0.8, 1.0, 1.3}) hits.push_back({.hit = {.peak_N = factor * peak_N}, .accepted = true});
  const std::vector<Warning> warnings = hit_warnings({}, hits);
  return std::any_of(warnings.begin(), warnings.end(), [&](const Warning& one) { return one.code == code; });
}

// A force that is 1000 times too large, as where a sensitivity in V/N was stated as mV/N.
TEST(HitWarnings, DoubtAForceAboveThatOfAllHammers) {
  EXPECT_FALSE(warns(257, "implausible_force"));
  EXPECT_FALSE(warns(22e3, "implausible_force"));
  EXPECT_TRUE(warns(257e3, "implausible_force"));
  EXPECT_TRUE(warns(-257e3, "implausible_force"));
}

}  // namespace percuss::pipeline::hit_warnings_test
