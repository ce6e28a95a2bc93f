#include "pipeline/hits/motion_before.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/impact_test.hpp"
#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::motion_before_test {

using testing::Contains;
using testing::ElementsAre;
using testing::Field;

// A mode whose time constant is 0.5 s, struck in one long record.
acquire::Record struck_at(const std::vector<double>& times_s) {
  synth::SynthSpec spec = test::bat_spec(
      {{.freq_Hz = 98, .damping_ratio = 0.0031, .order = 1, .amplitude_per_sqrt_kg = 1.7}}, times_s.back() + 1.5);
  spec.layout = synth::SynthLayout::continuous;
  spec.hit_times_s = times_s;
  spec.hits = times_s.size();
  spec.noise = {.force = 1e-5, .accel = 1e-3};
  return synth::synthesise(spec).record;
}

Analysis analysis_of(acquire::Record record) {
  return {std::move(record), {.band_Hz = std::pair{60.0, 1000.0}, .threads = 1}};
}

TEST(MotionBefore, IsFoundWhereTheLastBlowStillRings) {
  const Analysis analysis = analysis_of(struck_at({0.2, 2.4, 10}));
  EXPECT_THAT(moves_before(analysis.record(), analysis.force_hits(), {0, 1, 2}, 1), ElementsAre(false, true, false));
}

// 2.2 s after the last blow, 1.5 % of the motion is left: too little to see in the pre-trigger of 16 ms, but an
// integral would take it for a bias and a drift, and be off by up to ten metres at the record's end.
TEST(MotionBefore, LeavesTheDeflectionToTheModes) {
  const Analysis analysis = analysis_of(struck_at({0.2, 2.4}));
  const ImpactTest test = deflect(analysis);
  ASSERT_EQ(test.hits.size(), 4U);
  for (const DeflectedHit& hit : test.hits) {
    EXPECT_EQ(hit.deflection.method,
              hit.hit == 0 ? metrics::DeflectionMethod::drift_free : metrics::DeflectionMethod::modal);
  }
  for (const std::size_t of_second : {2U, 3U}) {
    for (const double value_m : test.hits[of_second].deflection.deflection_m) ASSERT_LT(std::abs(value_m), 0.01);
  }
  EXPECT_THAT(test.warnings, Contains(Field(&Warning::code, "earlier_ringing")));
}

TEST(MotionBefore, IsStatedWhereAnIntegralWasAskedFor) {
  const Analysis analysis = analysis_of(struck_at({0.2, 2.4}));
  const ImpactTest test = deflect(analysis, {.deflection = {.method = metrics::DeflectionMethod::drift_free}});
  EXPECT_THAT(test.warnings, Contains(Field(&Warning::code, "not_at_rest")));
}

}  // namespace percuss::pipeline::motion_before_test
