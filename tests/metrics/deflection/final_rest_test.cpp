#include "metrics/deflection/final_rest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "metrics/deflection/deflection.hpp"
#include "support/magnitude.hpp"
#include "synth/pulse.hpp"

namespace percuss::metrics::final_rest_test {

constexpr double kFs_Hz = 4096, kRest_s = 0.1, kResidue_per_kg = 1.5;
constexpr double kNoise_mps2 = 0.02;  // standard deviation of a sample

// A blow on a structure with these modes; their exact deflection.
struct Blow {
  std::vector<double> accel_mps2, deflection_m;
};
Blow blow_on(const std::vector<synth::SynthPole>& poles, double length_s, double rigid_per_kg = 0) {
  const auto samples = static_cast<std::size_t>(length_s * kFs_Hz);
  const synth::PulseBasis basis =
      synth::pulse_basis({.onset_s = kRest_s, .width_s = 0.002, .peak_N = 200}, kFs_Hz, poles, 0, samples);
  Blow out{.accel_mps2 = std::vector<double>(samples), .deflection_m = {}};
  std::vector<double> force(samples);
  std::copy(basis.force_N.begin(), basis.force_N.end(), force.begin() + static_cast<std::ptrdiff_t>(basis.first));
  std::vector<ModalContribution> modes;
  for (std::size_t m = 0; m < poles.size(); ++m) {
    modes.push_back({.pole = {poles[m].freq_Hz, poles[m].damping_ratio}, .residue_per_kg = kResidue_per_kg});
    for (std::size_t i = basis.first; i < samples; ++i) {
      const std::size_t k = i - basis.first;
      const double regular = k < basis.regular_N[m].size() ? basis.regular_N[m][k] : 0;
      out.accel_mps2[i] += kResidue_per_kg * (regular + force[i]);
    }
  }
  for (std::size_t i = 0; i < samples; ++i) out.accel_mps2[i] += rigid_per_kg * force[i];
  out.deflection_m = modal_deflection(force, kFs_Hz, modes, rigid_per_kg).deflection_m;
  return out;
}

Deflection measured(const Blow& blow, std::mt19937& random) {
  std::normal_distribution<double> gauss;
  std::vector<double> accel = blow.accel_mps2;
  const double bias = 0.3 * gauss(random);
  for (double& a : accel) a += bias + kNoise_mps2 * gauss(random);
  return deflection_of({.fs_Hz = kFs_Hz, .accel_mps2 = accel, .onset_s = kRest_s, .force_N = {}, .modes = {}});
}

// A bat in a clamp that damps heavily rests after 0.2 to 0.5 s. The longer the record goes on, the farther its integral
// drifted: by 100 mm in 3 s, of a motion of 2 mm.
TEST(FinalRest, ShowsThatAHeavilyDampedStructureIsHeld) {
  constexpr int kRecords = 20;
  constexpr int kAtLeast = 18;  // chance takes the noise of one in a hundred rests for coloured
  std::mt19937 random(1);
  for (const double damping : {0.05, 0.12}) {
    const Blow blow = blow_on({{21.3, damping}, {205, 0.03}}, 3);
    const double true_m = test::largest_magnitude(blow.deflection_m);
    int held = 0;
    for (int record = 0; record < kRecords; ++record) {
      const Deflection found = measured(blow, random);
      ASSERT_TRUE(found.has_peak());
      EXPECT_LT(std::abs(std::abs(found.peak_m) - true_m), 4.5 * found.peak_std_m);
      if (!found.zero_mean_corrected) continue;
      ++held;
      EXPECT_LT(found.drift_m, true_m) << damping;
      for (std::size_t i = blow.deflection_m.size() / 8; i < blow.deflection_m.size(); i += 512)
        EXPECT_LT(std::abs(found.deflection_m[i] - blow.deflection_m[i]), 4.5 * found.std_m[i]) << damping << ", " << i;
    }
    EXPECT_GE(held, kAtLeast) << damping;
  }
}

// The acceleration of a body that flies away is noise, too, once its vibration has decayed. Its deflection does not
// return. Bands of 0.02 to 1 Hz pull a body back too late, or still swing.
TEST(FinalRest, IsNoRestPositionOfAFreeOrHungBody) {
  std::mt19937 random(2);
  std::vector<Blow> blows{blow_on({{205, 0.05}}, 2, 1.1)};
  for (const double suspension_Hz : {0.02, 0.3, 1.0}) blows.push_back(blow_on({{suspension_Hz, 0.05}, {205, 0.05}}, 2));
  for (std::size_t b = 0; b < blows.size(); ++b) {
    for (int record = 0; record < 10; ++record)
      EXPECT_FALSE(measured(blows[b], random).zero_mean_corrected) << b << ", " << record;
  }
}

// Noise is the measure of rest: without it, or with a motion before the blow, nothing is concluded.
TEST(FinalRest, NeedsNoiseBeforeTheBlow) {
  const std::vector<double> zeros(1000, 0.0);
  EXPECT_FALSE(final_rest_correction(zeros, zeros, kFs_Hz, baseline_estimate(zeros, kFs_Hz, 0)).held);
  EXPECT_FALSE(final_rest_correction(zeros, zeros, kFs_Hz, baseline_estimate({}, kFs_Hz, 1)).held);
}

}  // namespace percuss::metrics::final_rest_test
