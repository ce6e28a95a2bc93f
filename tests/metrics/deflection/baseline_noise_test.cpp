#include "metrics/deflection/baseline_noise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "core/math/fft.hpp"
#include "core/units.hpp"
#include "metrics/deflection/deflection.hpp"
#include "support/magnitude.hpp"
#include "synth/pulse.hpp"

namespace percuss::metrics::baseline_noise_test {

constexpr double kFs_Hz = 4096, kRest_s = 0.1;
constexpr double kWhite_mps2 = 0.02;  // standard deviation of a sample
constexpr double kStrength = 2e-5;    // (m/s²)²: as strong as the white noise at 102 Hz, ten times as strong at 10 Hz

// Noise of the one-sided power spectral density K/f, from lines of random phase. It is a part of a longer sequence, so
// that it contains frequencies below one period per record.
std::vector<double> flicker_noise(double strength, std::size_t samples, std::mt19937& random) {
  std::normal_distribution<double> gauss;
  const std::size_t length = 8 * samples;
  std::vector<Complex> lines(length / 2 + 1);
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const double density = strength / (static_cast<double>(k) * kFs_Hz / static_cast<double>(length));
    const double size = std::sqrt(density * static_cast<double>(length) * kFs_Hz / 4);
    lines[k] = {size * gauss(random), size * gauss(random)};
  }
  std::vector<double> noise = inverse_real_dft(lines, length);
  noise.resize(samples);
  return noise;
}

// The blow of a hammer on a structure with these modes, of residue 1.5 kg⁻¹ each, behind an anti-alias filter.
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
    modes.push_back({.pole = {poles[m].freq_Hz, poles[m].damping_ratio}, .residue_per_kg = 1.5});
    for (std::size_t i = 0; i < samples - basis.first; ++i) {
      const double regular = i < basis.regular_N[m].size() ? basis.regular_N[m][i] : 0;
      out.accel_mps2[basis.first + i] += 1.5 * (regular + force[basis.first + i]);
    }
  }
  for (std::size_t i = 0; i < samples; ++i) out.accel_mps2[i] += rigid_per_kg * force[i];
  out.deflection_m = modal_deflection(force, kFs_Hz, modes, rigid_per_kg).deflection_m;
  return out;
}

const std::vector<synth::SynthPole> kHeldBeam{{14.6, 0.012}, {118, 0.01}, {340, 0.008}};

std::vector<double> measured(const Blow& blow, double strength, std::mt19937& random) {
  std::normal_distribution<double> gauss;
  std::vector<double> accel = flicker_noise(strength, blow.accel_mps2.size(), random);
  const double bias = 0.3 * gauss(random);
  for (std::size_t i = 0; i < accel.size(); ++i) accel[i] += blow.accel_mps2[i] + bias + kWhite_mps2 * gauss(random);
  return accel;
}

ImpactSignal signal_of(const std::vector<double>& accel, std::optional<double> strength = {}) {
  return {.fs_Hz = kFs_Hz,
          .accel_mps2 = accel,
          .onset_s = kRest_s,
          .force_N = {},
          .modes = {},
          .flicker_strength = strength};
}

TEST(FlickerCovariance, HasTheAllanVarianceOfFlickerNoise) {
  // Of means over two adjacent intervals of any length: 2 ln 2 times the strength. An octave between the rates of the
  // processes changes it by less than 1 %. Noise faster than half the sampling rate is left out.
  constexpr double kTolerance = 0.02;
  for (const double length_s : {0.02, 0.05, 0.1}) {
    const BaselineBlocks blocks{
        .begin_s = {-2, 0, length_s, 1}, .end_s = {-1, length_s, 2 * length_s, 2}, .first = {}, .at_rest = 1};
    const Eigen::MatrixXd covariance = flicker_covariance(blocks, kFs_Hz);
    const double allan = (covariance(1, 1) + covariance(2, 2) - 2 * covariance(1, 2)) / 2;
    EXPECT_NEAR(allan, 2 * std::numbers::ln2, kTolerance * 2 * std::numbers::ln2) << length_s;
  }
}

TEST(BaselineBlocks, CoverEverySample) {
  for (const std::size_t rest : {64U, 1000U, 30000U}) {
    const BaselineBlocks blocks = baseline_blocks(rest, 7777, kFs_Hz);
    ASSERT_EQ(blocks.first.size(), blocks.size() + 1);
    EXPECT_EQ(blocks.first.front(), 0U);
    EXPECT_EQ(blocks.first[blocks.at_rest], rest);
    EXPECT_EQ(blocks.first.back(), rest + 7777);
    EXPECT_TRUE(std::is_sorted(blocks.first.begin(), blocks.first.end(), std::less_equal<>()));
    // A constant acceleration of 1 m/s² after the rest.
    const double end_s = blocks.end_s.back();
    EXPECT_NEAR(deflection_by_block(blocks, end_s, 0).sum(), end_s * end_s / 2, 1e-9);
  }
}

// In white noise, and in the leakage of a clean record, there is no 1/f noise, and nothing changes.
TEST(FlickerStrength, IsZeroForWhiteNoise) {
  const Blow blow = blow_on(kHeldBeam, 1.2);
  std::mt19937 random(1);
  int found = 0;
  for (int record = 0; record < 40; ++record) {
    std::vector<double> accel = measured(blow, 0, random);
    const double strength = flicker_strength(flicker_evidence(signal_of(accel)).log_gains);
    found += strength > 0 ? 1 : 0;
    if (strength > 0) continue;
    const Deflection unknown = deflection_of(signal_of(accel)), zero = deflection_of(signal_of(accel, 0.0));
    EXPECT_EQ(unknown.deflection_m, zero.deflection_m);
    EXPECT_EQ(unknown.std_m, zero.std_m);
  }
  // A likelihood ratio of e³ is exceeded by chance in less than one of 100 records.
  EXPECT_LE(found, 2);
  EXPECT_EQ(flicker_strength(flicker_evidence(signal_of(blow.accel_mps2)).log_gains), 0);  // without noise
}

TEST(FlickerStrength, IsFoundFromSeveralRecords) {
  const Blow held = blow_on(kHeldBeam, 1.2), free = blow_on({{147, 0.01}, {560, 0.008}}, 1.2, 1.1);
  for (const Blow* blow : {&held, &free}) {
    std::mt19937 random(2);
    std::vector<double> sum(kFlickerStrengths);
    constexpr int kRecords = 10;
    for (int record = 0; record < kRecords; ++record) {
      const std::vector<double> accel = measured(*blow, kStrength, random);
      const std::vector<double> gains = flicker_evidence(signal_of(accel)).log_gains;
      ASSERT_EQ(gains.size(), kFlickerStrengths);
      std::transform(sum.begin(), sum.end(), gains.begin(), sum.begin(), std::plus<>());
    }
    // The rest of 0.1 s in each record gives some ten degrees of freedom. The limits are a factor of 2.
    EXPECT_GT(flicker_strength(sum), kStrength / 2);
    EXPECT_LT(flicker_strength(sum), kStrength * 2);
  }
}

// Shock accelerometers have 1/f noise. Integrated, it exceeds the motion late in the record; these samples must not
// count as the largest deflection, and the ± must hold the error that the noise makes at the true one.
TEST(DeflectionInFlickerNoise, IsTheLargestOfTheMotionWithinItsStandardDeviation) {
  struct Case {
    double length_s, strength;
    bool known;  // the strength, from other records
  };
  for (const Case& of : {Case{1.1, kStrength, false}, Case{2.1, kStrength, false}, Case{2.1, kStrength / 10, true},
                         Case{2.1, 100 * kStrength, true}}) {
    const Blow blow = blow_on(kHeldBeam, of.length_s);
    const double true_m = test::largest_magnitude(blow.deflection_m);
    std::mt19937 random(3);
    double squares = 0;
    constexpr int kRecords = 40;
    for (int record = 0; record < kRecords; ++record) {
      const std::vector<double> accel = measured(blow, of.strength, random);
      const Deflection found = deflection_of(signal_of(accel, of.known ? std::optional(of.strength) : std::nullopt));
      ASSERT_TRUE(found.has_peak());
      EXPECT_TRUE(found.zero_mean_corrected);
      EXPECT_LT(std::abs(found.peak_m), 1.3 * true_m) << of.length_s << ", " << of.strength << ", " << record;
      EXPECT_LT(found.peak_std_m, 0.1 * true_m);
      const double z = (std::abs(found.peak_m) - true_m) / found.peak_std_m;
      EXPECT_LT(std::abs(z), 4.5);
      squares += z * z;
    }
    // The rms of 40 deviates scatters by 11 %; the limits are 3.5 times that, and the strength is an estimate.
    EXPECT_LT(std::sqrt(squares / kRecords), 1.4) << of.length_s << ", " << of.strength;
    EXPECT_GT(std::sqrt(squares / kRecords), 0.6) << of.length_s << ", " << of.strength;
  }
}

// Late deflections of a held structure return to zero, and their ± says how far they may be off.
TEST(DeflectionInFlickerNoise, SwingsAboutTheRestPositionLateInTheRecord) {
  const Blow blow = blow_on(kHeldBeam, 2.1);
  const double true_m = test::largest_magnitude(blow.deflection_m);
  std::mt19937 random(5);
  for (int record = 0; record < 20; ++record) {
    const std::vector<double> accel = measured(blow, kStrength, random);
    const Deflection found = deflection_of(signal_of(accel));
    for (std::size_t i = accel.size() / 4; i < accel.size(); i += accel.size() / 16) {
      EXPECT_LT(std::abs(found.deflection_m[i] - blow.deflection_m[i]), 4.5 * found.std_m[i]) << record << ", " << i;
      EXPECT_LT(found.std_m[i], true_m) << record << ", " << i;
    }
  }
}

// A body that flies away does not return: its motion is no drift, whatever the noise.
TEST(DeflectionInFlickerNoise, KeepsTheMotionOfAFreeBody) {
  const Blow blow = blow_on({{147, 0.01}, {560, 0.008}}, 1.2, 1.1);
  std::mt19937 random(6);
  for (int record = 0; record < 20; ++record) {
    const std::vector<double> accel = measured(blow, kStrength, random);
    const Deflection found = deflection_of(signal_of(accel, kStrength));
    EXPECT_FALSE(found.zero_mean_corrected) << record;
    for (std::size_t i = accel.size() / 4; i < accel.size(); i += accel.size() / 16)
      EXPECT_LT(std::abs(found.deflection_m[i] - blow.deflection_m[i]), 4.5 * found.std_m[i]) << record << ", " << i;
  }
}

// Hum before the blow is no noise: its amplitude would be taken for strong noise at low frequencies.
TEST(BaselineNoise, IsNotTakenFromHum) {
  const Blow blow = blow_on(kHeldBeam, 1.2);
  std::mt19937 random(7);
  std::vector<double> accel = measured(blow, 0, random);
  for (std::size_t i = 0; i < accel.size(); ++i)
    accel[i] += 0.2 * std::sin(kTwoPi * 50 * static_cast<double>(i) / kFs_Hz);
  EXPECT_TRUE(flicker_evidence(signal_of(accel)).log_gains.empty());
}

// The integration of the evidence serves for the deflection, too.
TEST(BaselineNoise, GivesTheSameDeflectionFromTheMotionOfTheEvidence) {
  std::mt19937 random(7);
  for (const double strength : {0.0, kStrength}) {
    const std::vector<double> accel = measured(blow_on(kHeldBeam, 2), strength, random);
    ImpactSignal signal = signal_of(accel);
    const Deflection integrated = deflection_of(signal);
    signal.motion = flicker_evidence(signal).motion;
    ASSERT_NE(signal.motion, nullptr);
    const Deflection taken = deflection_of(signal);
    EXPECT_EQ(taken.deflection_m, integrated.deflection_m);
    EXPECT_EQ(taken.velocity_mps, integrated.velocity_mps);
    EXPECT_EQ(taken.std_m, integrated.std_m);
  }
}

}  // namespace percuss::metrics::baseline_noise_test
