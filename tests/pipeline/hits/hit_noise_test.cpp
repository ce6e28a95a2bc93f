#include "pipeline/hits/hit_noise.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace percuss::pipeline::hit_noise_test {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::size_t kLines = 100, kSamples = 4096;

/// add_hit() adds a hit with one response, whose energy is `energy_ratio` times the energy of its noise. With low
/// coherence, the other hits explain nothing of it.
class HitNoise : public testing::Test {
 protected:
  void add_hit(double energy_ratio, bool low_coherence = true) {
    // The noise of 0.5 m/s² has on each line the energy 0.25 Σ w².
    const double decay = 2 * options_.window_decay_per_s / options_.lines.fs_Hz;
    double window = 0;
    for (std::size_t i = 0; i < kSamples; ++i) window += std::exp(-decay * static_cast<double>(i));
    spectra_.emplace_back(kLines, Complex(0, std::sqrt(energy_ratio * 0.25 * window)));
    hits_.push_back({.hit = {.peak_N = 100}, .point = 0, .accepted = true});
    hits_.back().responses.resize(1);
    if (low_coherence) {
      hits_.back().hit.findings.push_back({.code = acquire::FindingCode::low_coherence,
                                           .severity = acquire::Severity::warn,
                                           .value = 0,
                                           .message = ""});
    }
    responses_.of.emplace_back(1);
    responses_.of.back()[0].rest.before = 0;
    responses_.of.back()[0].rest.noise = 0.5;
  }
  std::set<std::size_t> found() {
    for (std::size_t h = 0; h < hits_.size(); ++h) responses_.of[h][0].spectrum = spectra_[h];
    return hits_that_differ_by_noise(hits_, responses_, options_);
  }
  TransformOptions options_{.lines = {.fs_Hz = 4096, .samples = kSamples, .first = 0, .count = kLines}};
  std::vector<AnalysedHit> hits_;
  std::vector<std::vector<Complex>> spectra_;
  HitResponses responses_{.of = {}, .lines = UninitializedArray<Complex>(0)};
};

TEST_F(HitNoise, IsAllThatDiffersUpToFourTimesItsEnergy) {
  for (const double ratio : {0.5, 1.5, 3.9, 4.1, 100.0}) add_hit(ratio);
  EXPECT_THAT(found(), ElementsAre(0, 1, 2));
}

TEST_F(HitNoise, CountsOnlyTheUnexplainedPart) {
  add_hit(7);
  EXPECT_THAT(found(), IsEmpty());
  hits_[0].hit.findings[0].value = 0.45;
  EXPECT_THAT(found(), ElementsAre(0));
}

TEST_F(HitNoise, IsReducedByTheExponentialWindow) {
  options_.window_decay_per_s = 3;
  for (const double ratio : {3.9, 4.1}) add_hit(ratio);
  EXPECT_THAT(found(), ElementsAre(0));
}

TEST_F(HitNoise, IsUnknownWithoutSamplesAtRestBeforeTheHit) {
  for (std::size_t h = 0; h < 2; ++h) add_hit(1);
  responses_.of[0][0].rest.before.reset();
  hits_[1].responses[0].may_ring_before = true;
  EXPECT_THAT(found(), IsEmpty());
}

TEST_F(HitNoise, ConcernsAcceptedHitsThatDisagree) {
  add_hit(1, false);
  add_hit(1);
  hits_[1].accepted = false;
  EXPECT_THAT(found(), IsEmpty());
}

TEST_F(HitNoise, HitsOnNodeLinesExciteLittle) {
  // Six hits excite an energy of 100. A hit that excites a twentieth of it is faulty; one that excites a hundredth lies
  // on a node line.
  for (int h = 0; h < 6; ++h) add_hit(100, false);
  for (const double energy : {5.0, 1.0, 100.0}) add_hit(energy);
  add_hit(16);
  hits_.back().hit.peak_N = 400;  // excites 1 at 100 N
  found();
  EXPECT_THAT(hits_on_node_lines(hits_, responses_), ElementsAre(7, 9));
}

}  // namespace percuss::pipeline::hit_noise_test
