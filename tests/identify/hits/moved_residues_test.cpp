#include "identify/hits/moved_residues.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "identify/model/frf_synthesis.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::moved_residues_test {

// Two modes of 16 Hz bandwidth at two channels.
struct Pair {
  FrfDataset set = test::empty_set(4000, 4000, 600, 1400, 2);
  std::vector<Mode> modes;

  Pair(double low_Hz, double high_Hz) {
    for (const double freq_Hz : {low_Hz, high_Hz}) {
      Mode mode{.pole = {.freq_Hz = freq_Hz, .damping_ratio = 8 / freq_Hz}};
      const double sign = freq_Hz == low_Hz ? 1 : -1;
      mode.residues = {{.channel = 0, .value = {sign, 0.3}}, {.channel = 1, .value = {2.0, 0.2 * sign}}};
      for (std::size_t c = 0; c < 2; ++c) test::add_mode(set, c, mode.pole, mode.residues[c].value);
      modes.push_back(mode);
    }
  }
  std::vector<Pole> poles() const { return {modes[0].pole, modes[1].pole}; }
  double worst_frac() const {
    double worst = 1;
    for (const SynthesisedFrf& frf : synthesised_frfs(set, modes, set.lines)) worst = std::min(worst, frf.frac);
    return worst;
  }
};

constexpr ModeWindow window_of(std::size_t first, std::size_t count) {
  return {.modes = {0, 1}, .first = first, .count = count};
}

// The upper pole moves by a quarter of the poles' distance.
TEST(MovedPoles, ResiduesOfClosePolesDescribeTheFrfs) {
  Pair pair(984, 987.2);
  const std::vector<Pole> before = pair.poles();
  pair.modes[1].pole.freq_Hz += 0.8;
  EXPECT_LT(pair.worst_frac(), 0.98);
  move_residues(pair.set, window_of(304, 160), before, pair.modes);
  EXPECT_GT(pair.worst_frac(), 0.999);
}

// A pole moves from the true value to a wrong one and back. Each step adds the difference of two least-squares
// solutions to the residues, so they return exactly.
TEST(MovedPoles, ResiduesReturnWithThePoles) {
  Pair pair(984, 987.2);
  const std::vector<Mode> truth = pair.modes;
  const std::vector<Pole> poles = pair.poles();
  pair.modes[1].pole.freq_Hz += 1.6;
  const std::vector<Pole> moved = pair.poles();
  move_residues(pair.set, window_of(304, 160), poles, pair.modes);
  EXPECT_GT(std::abs(pair.modes[0].residues[0].value - truth[0].residues[0].value), 0.2);
  pair.modes[1].pole = truth[1].pole;
  move_residues(pair.set, window_of(304, 160), moved, pair.modes);
  for (std::size_t m = 0; m < 2; ++m) {
    for (std::size_t c = 0; c < 2; ++c)
      EXPECT_LT(std::abs(pair.modes[m].residues[c].value - truth[m].residues[c].value), 1e-6);
  }
}

// If a resonance drifts from hit to hit, it is broader in the mean FRF, but has the same residue. So the residue stays
// when the damping changes.
TEST(MovedPoles, SeparateModesKeepTheirResidues) {
  Pair pair(900, 1100);
  const std::vector<Mode> truth = pair.modes;
  const std::vector<Pole> before = pair.poles();
  pair.modes[0].pole.damping_ratio *= 0.9;
  pair.modes[1].pole.freq_Hz += 1.6;
  move_residues(pair.set, window_of(200, 400), before, pair.modes);
  for (std::size_t m = 0; m < 2; ++m) {
    for (std::size_t c = 0; c < 2; ++c) EXPECT_EQ(pair.modes[m].residues[c].value, truth[m].residues[c].value);
  }
}

}  // namespace percuss::identify::moved_residues_test
