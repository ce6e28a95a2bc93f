// Bending or hoop over many random bats: classifications are right as often as their confidence states.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel/parallel.hpp"
#include "pipeline/analysis.hpp"
#include "support/random_bat.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::classification_calibration_test {

constexpr std::size_t kBats = 240;
constexpr double kConfident = 0.9;

// A mode that was found, compared with the truth.
struct CheckedMode {
  identify::ModeClassification classification;
  bool matched = false;  // with a mode of the truth, within three half-power bandwidths
  bool right = false;
};

bool is(identify::ModeType type, synth::SynthModeType truth) {
  return type == (truth == synth::SynthModeType::bending ? identify::ModeType::bending : identify::ModeType::hoop);
}

std::vector<CheckedMode> checked_bat(std::uint64_t seed) {
  const synth::SynthSpec spec = test::random_bat(seed);
  const Analysis analysis(
      test::with_sensor_angles(synth::synthesise(spec, 1).record),
      {.band_Hz = std::pair{60.0, spec.band_high_Hz}, .modes = {.effort = identify::Effort::standard}});
  std::vector<CheckedMode> out;
  for (std::size_t m = 0; m < analysis.modes().size(); ++m) {
    const double freq_Hz = analysis.modes()[m].pole.freq_Hz;
    const auto distance = [&](const synth::SynthMode& t) { return std::abs(t.freq_Hz - freq_Hz); };
    const auto& nearest = *std::min_element(spec.modes.begin(), spec.modes.end(),
                                            [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    out.push_back({.classification = analysis.classifications()[m],
                   .matched = distance(nearest) <= 3 * 2 * nearest.damping_ratio * nearest.freq_Hz,
                   .right = is(analysis.classifications()[m].type, nearest.type)});
  }
  return out;
}

std::vector<std::vector<CheckedMode>> checked_bats() {
  std::vector<std::vector<CheckedMode>> bats(kBats);
  parallel_for(kBats, 0, [&](std::size_t i) { bats[i] = checked_bat(i); });
  for (auto& bat : bats) std::erase_if(bat, [](const CheckedMode& j) { return !j.matched; });
  return bats;
}

/// Classifications whose confidence lies in [low, high). Errors within one bat are correlated, because its modes share
/// plane and sensors: the bats, not the classifications, are independent.
struct Pool {
  double classifications = 0, right = 0, confidence = 0;
  double expected_variance = 0;      // of the number right, if the confidences are true and the errors independent
  double variance_by_bats = 0;       // Σ over the bats of (number right − Σ confidence)²
  double wrong_squared_by_bats = 0;  // Σ over the bats of (number of wrong classifications)²
};

Pool pool_of(const std::vector<std::vector<CheckedMode>>& bats, double low, double high) {
  Pool pool;
  for (const auto& bat : bats) {
    double surplus = 0, wrong = 0;
    for (const CheckedMode& j : bat) {
      const double p = j.classification.confidence;
      if (j.classification.type == identify::ModeType::unknown || p < low || p >= high) continue;
      ++pool.classifications;
      pool.right += j.right;
      pool.confidence += p;
      pool.expected_variance += p * (1 - p);
      surplus += j.right - p;
      wrong += !j.right;
    }
    pool.variance_by_bats += surplus * surplus;
    pool.wrong_squared_by_bats += wrong * wrong;
  }
  return pool;
}

/// Of the classifications with a confidence of 90 % or more, 95 % are right. The fraction exceeds 95 % by 1.645
/// standard errors, so that a method that is right less often passes in one population of twenty at most. 75 % of all
/// modes must have such a confidence, so that a method cannot pass by abstaining.
void expect_confident_classifications_right(const std::vector<std::vector<CheckedMode>>& bats) {
  const Pool sure = pool_of(bats, kConfident, 1.1);
  double all = 0;
  for (const auto& bat : bats) all += static_cast<double>(bat.size());
  const double fraction = sure.right / sure.classifications,
               error = std::sqrt(sure.wrong_squared_by_bats) / sure.classifications;
  EXPECT_GE(fraction - 1.645 * error, 0.95) << fraction << " of " << sure.classifications << " ± " << error;
  EXPECT_GE(all, 5 * kBats);
  EXPECT_GE(sure.classifications / all, 0.75) << sure.classifications << " of " << all;
}

void expect_doubts_named(const std::vector<std::vector<CheckedMode>>& bats) {
  for (std::size_t i = 0; i < bats.size(); ++i) {
    for (const auto& [classification, matched, right] : bats[i]) {
      if (classification.confidence >= kConfident) continue;
      EXPECT_TRUE(classification.type == identify::ModeType::unknown || classification.alternative) << "bat " << i;
      EXPECT_NE(classification.alternative, classification.type) << "bat " << i;
    }
  }
}

/// In each bin of confidence the number of right classifications is the sum of the confidences, within three standard
/// deviations.
void expect_calibrated(const std::vector<std::vector<CheckedMode>>& bats) {
  constexpr std::array<double, 5> kEdges{0.6, 0.8, 0.9, 0.97, 1.1};
  for (std::size_t b = 0; b + 1 < kEdges.size(); ++b) {
    const Pool bin = pool_of(bats, kEdges[b], kEdges[b + 1]);
    const double deviation = std::sqrt(std::max(bin.expected_variance, bin.variance_by_bats));
    EXPECT_GE(bin.classifications, 20) << kEdges[b];
    EXPECT_NEAR(bin.right, bin.confidence, 3 * deviation) << kEdges[b] << ": of " << bin.classifications;
  }
}

// One test, because each test would have to make all bats.
TEST(Classification, IsCalibratedOverRandomBats) {
  const auto bats = checked_bats();
  expect_confident_classifications_right(bats);
  expect_doubts_named(bats);
  expect_calibrated(bats);
}

}  // namespace percuss::pipeline::classification_calibration_test
