#include "identify/hits/residue_coherence.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "core/units.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::residue_coherence_test {

constexpr std::size_t kHits = 5;
constexpr Pole kPole{.freq_Hz = 250, .damping_ratio = 0.004};

// Hits of 1 N at one point with two accelerometers. phase_turns(hit, channel) is the phase of the mode's residue.
double coherence_of(const std::function<double(std::size_t, std::size_t)>& phase_turns, std::uint64_t seed) {
  FrfDataset set = test::empty_set(2000, 2000, 150, 350, 2);
  HitFrfs hits{.set = {.lines = set.lines, .usable_bandwidth_Hz = set.usable_bandwidth_Hz}};
  std::vector<std::vector<Complex>> spectra;
  Mode mode{.pole = kPole};
  mode.residues = {{.channel = 0}, {.channel = 1}};
  for (std::size_t h = 0; h < kHits; ++h) {
    FrfDataset one = test::empty_set(2000, 2000, 150, 350, 2);
    for (std::size_t c = 0; c < 2; ++c) {
      const Complex residue = std::polar(1.0, kTwoPi * phase_turns(h, c));
      test::add_mode(one, c, kPole, residue);
      mode.residues[c].value += residue / static_cast<double>(kHits);
    }
    test::add_frf_noise(one, 1e-3, kHits * seed + h);
    const Complex* const force = one.points.front().spectra.front().get();
    hits.set.points.push_back(one.points.front());
    hits.points.push_back(0);
    for (std::size_t c = 0; c < 2; ++c) {
      for (std::size_t k = 0; k < one.lines.count; ++k) one.channels[c].frf[k] *= force[k];
      spectra.push_back(one.channels[c].frf);
      hits.set.channels.push_back({.point = h, .channel = c, .frf = {}});
    }
  }
  for (const std::vector<Complex>& spectrum : spectra) hits.accel.emplace_back(spectrum);
  const ModeWindow window{.modes = {0}, .first = 50, .count = 101};
  return residue_coherence(set, hits, {mode}, window, 0).front().coherence;
}

// The mean of |Σ r|²/(n Σ|r|²) over independent phases is 1/n. The coherence of two channels with about equal weights
// has the variance (n − 1)/(2 n³), so that the mean of 60 draws has the standard deviation 0.016. The noise makes the
// weights of the hits differ by a tenth. A single residue per hit, the projection of both channels onto their mean
// residues, would give 0.35.
TEST(ResidueCoherence, IsOneOverTheHitsForIndependentPhases) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> turns(0, 1);
  constexpr int kDraws = 60;
  double mean = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    const auto independent = [&](std::size_t, std::size_t) { return turns(random); };
    mean += coherence_of(independent, static_cast<std::uint64_t>(draw) + 1) / kDraws;
  }
  EXPECT_NEAR(mean, 1.0 / kHits, 3 * 0.016);
}

TEST(ResidueCoherence, IsOneForEqualResidues) {
  const auto of_channel = [](std::size_t, std::size_t channel) { return channel == 0 ? 0.1 : 0.45; };
  EXPECT_GT(coherence_of(of_channel, 1), 0.999);
}

}  // namespace percuss::identify::residue_coherence_test
