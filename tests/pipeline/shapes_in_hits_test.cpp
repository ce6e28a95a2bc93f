#include "pipeline/shapes_in_hits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "pipeline/survey.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::shapes_in_hits_test {

constexpr double kDeviations = 5;  // allowed standard deviations; 5, because dozens of values are compared

synth::SynthSpec two_sensors(std::size_t hits) {
  synth::SynthSpec spec;
  spec.fs_Hz = 8192;
  spec.samples = 8192;
  spec.seed = 4;
  spec.band_high_Hz = 3000;
  const auto mode = [&](double freq_Hz, double damping, int order) {
    spec.modes.push_back({.freq_Hz = freq_Hz,
                          .damping_ratio = damping,
                          .type = synth::SynthModeType::bending,
                          .order = order,
                          .angle_rad = 0.3,
                          .amplitude_per_sqrt_kg = 2});
  };
  mode(205, 0.02, 1);
  mode(690, 0.008, 2);
  spec.sensors = {{.position_m = 0.05, .angle_rad = 0}, {.position_m = 0.05, .angle_rad = 1.5}};
  spec.points.clear();
  for (int p = 0; p < 6; ++p) spec.points.push_back({.position_m = 0.05 + 0.05 * p, .angle_rad = 0});
  spec.pulse.width_s = 0.25e-3;
  spec.noise = {.force = 1e-4, .accel = 1e-3};
  spec.hits = hits;
  return spec;
}

// The weighted mean over the hits of a point is the shape of the test, in its scale.
TEST(ShapesInHits, AverageToTheShapes) {
  const synth::SyntheticTest made = synth::synthesise(two_sensors(3));
  const Analysis analysis(made.record, {.band_Hz = std::pair{60.0, 1500.0}, .budget = Budget{}});
  for (const identify::Roving roving : {identify::Roving::hammer, identify::Roving::sensor}) {
    const Survey survey(analysis, {.roving = roving});
    const std::vector<identify::ModeShape>& shapes = survey.shapes();
    const auto in_hits = shapes_in_hits(analysis, survey.split_modes(), shapes, roving);
    ASSERT_EQ(shapes.size(), 2U);
    ASSERT_EQ(in_hits.size(), 2U);
    for (std::size_t m = 0; m < 2; ++m) {
      ASSERT_EQ(in_hits[m].size(), roving == identify::Roving::hammer ? 6U : 12U);
      for (std::size_t i = 0; i < in_hits[m].size(); ++i) {
        ASSERT_EQ(in_hits[m][i].size(), 3U);
        Complex mean;
        double power = 0, noise2 = 0;
        for (const identify::ValueInHit& one : in_hits[m][i]) {
          mean += one.power * one.value;
          noise2 += one.power * one.power * one.std * one.std;
          power += one.power;
        }
        const double std = std::hypot(std::sqrt(noise2) / power, shapes[m].places[i].std);
        EXPECT_LT(std::abs(mean / power - shapes[m].places[i].value), kDeviations * std) << m << " " << i;
      }
    }
  }
}

TEST(ShapesInHits, AreUnknownWithOneHitPerPoint) {
  const synth::SyntheticTest made = synth::synthesise(two_sensors(1));
  const Analysis analysis(made.record, {.band_Hz = std::pair{60.0, 1500.0}, .budget = Budget{}});
  const Survey survey(analysis, {});
  EXPECT_TRUE(shapes_in_hits(analysis, survey.split_modes(), survey.shapes(), survey.roving()).empty());
}

}  // namespace percuss::pipeline::shapes_in_hits_test
