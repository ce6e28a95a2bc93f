#include "synth/schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace percuss::synth::schedule_test {

TEST(Schedule, JittersWithinItsBounds) {
  SynthSpec spec;
  spec.samples = 4096;
  spec.seed = 9;
  spec.points = {{.angle_rad = 0.35}};
  spec.hits = 200;
  const std::vector<TrueHit> hits = schedule_hits(spec);
  ASSERT_EQ(hits.size(), 200U);
  for (const TrueHit& hit : hits) {
    EXPECT_GE(hit.onset_s, spec.pretrigger_s);
    EXPECT_LE(hit.onset_s, spec.pretrigger_s + spec.onset_spread_s);
    EXPECT_LE(std::abs(hit.width_s / spec.pulse.width_s - 1), 0.1);
    EXPECT_LE(std::abs(hit.peak_N / spec.pulse.peak_N - 1), 0.25);
  }
}

}  // namespace percuss::synth::schedule_test
