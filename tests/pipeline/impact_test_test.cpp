#include "pipeline/impact_test.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::impact_test_test {

ImpactTest deflect_with(std::optional<double> pretrigger_s) {
  synth::SynthSpec spec =
      test::bat_spec({{.freq_Hz = 205, .damping_ratio = 0.008, .order = 1, .amplitude_per_sqrt_kg = 1.7}}, 1.5);
  spec.layout = synth::SynthLayout::continuous;
  spec.hit_times_s = {0.5};
  spec.hits = 1;
  spec.noise = {.force = 1e-4, .accel = 1e-3};
  return deflect(Analysis(synth::synthesise(spec).record,
                          {.band_Hz = std::pair{60.0, 1000.0}, .hits = {.pretrigger_s = pretrigger_s}, .threads = 1}),
                 {.deflection = {.method = metrics::DeflectionMethod::drift_free, .free_body = true}});
}

// A longer rest before the hit determines bias and drift better. The rest of a pre-trigger of 5 ms would leave an
// uncertainty of about 1 m after a second. Here half a second of rest is recorded.
TEST(ImpactTest, TakesTheBiasFromALongRest) {
  const ImpactTest test = deflect_with({});
  ASSERT_FALSE(test.hits.empty());
  EXPECT_NEAR(test.hits[0].first_s, 0.4, 5e-3);  // 0.1 s of rest before the gate, which begins some ms before 0.5 s
  EXPECT_LT(test.hits[0].deflection.drift_m, deflect_with(0.01).hits.at(0).deflection.drift_m / 20);
}

TEST(ImpactTest, KeepsAStatedPretrigger) { EXPECT_NEAR(deflect_with(0.01).hits.at(0).first_s, 0.49, 1e-3); }

}  // namespace percuss::pipeline::impact_test_test
