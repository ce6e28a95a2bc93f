#include "identify/start/mif.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"

namespace percuss::identify::mif_test {

// H = A (jω)²/((jω)² + 2ζω_r jω + ω_r²) at lines 1 Hz apart.
FrfDataset one_mode(double freq_Hz, double damping_ratio) {
  FrfDataset set;
  set.lines = {.fs_Hz = 2000, .samples = 2000, .first = 50, .count = 200};
  set.channels.push_back({});
  const double omega_r = kTwoPi * freq_Hz;
  for (std::size_t k = 0; k < set.lines.count; ++k) {
    const Complex s(0, kTwoPi * set.lines.freq_Hz(k));
    set.channels[0].frf.push_back(s * s / (s * s + 2 * damping_ratio * omega_r * s + omega_r * omega_r));
  }
  return set;
}

// At resonance the accelerance of one mode is j/(2ζ): purely imaginary.
TEST(Mif, IsZeroAtAModeAndNearOneFarFromIt) {
  const FrfDataset set = one_mode(150, 0.01);
  const std::vector<double> values = mif(set, set.lines);
  EXPECT_NEAR(values[100], 0, 1e-12);
  EXPECT_GT(values[0], 0.99);
  // |Re H|/|H| = cos φ with tan φ = 2ζ r/(1 − r²), r = f/f_r.
  const double r = 140.0 / 150, phi = std::atan2(2 * 0.01 * r, 1 - r * r);
  EXPECT_NEAR(values[90], std::cos(phi), 1e-12);
}

TEST(Mif, IsOneWhereNothingWasMeasured) {
  FrfDataset set = one_mode(150, 0.01);
  set.channels[0].frf.assign(set.lines.count, 0);
  for (const double value : mif(set, set.lines)) EXPECT_EQ(value, 1);
}

}  // namespace percuss::identify::mif_test
