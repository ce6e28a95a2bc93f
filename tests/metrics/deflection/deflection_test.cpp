#include "metrics/deflection/deflection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/units.hpp"
#include "metrics/deflection/baseline_drift.hpp"
#include "support/magnitude.hpp"
#include "synth/pulse.hpp"

namespace percuss::metrics::deflection_test {

/// A mode of a held beam, struck for 3 ms: the closed-form response to a half sine.
struct Impact {
  double fs_Hz = 20000;
  std::vector<double> force_N, accel_mps2, deflection_m;
  double onset_s = 0;
};

constexpr double kFreq_Hz = 14.5, kDamping = 0.012, kResidue_per_kg = 2, kForce_N = 600, kPulse_s = 0.003;

identify::Pole pole() { return {.freq_Hz = kFreq_Hz, .damping_ratio = kDamping}; }

// The solution of x'' + 2ζωx' + ω²x = A·F sin(πt/T), for a sine that starts at t = 0. Two such sines, T apart, add up
// to a half sine.
struct State {
  double x = 0, v = 0, a = 0;
};

State started_sine(double t_s) {
  if (t_s <= 0) return {};
  const double w = kTwoPi * kFreq_Hz, wd = w * std::sqrt(1 - kDamping * kDamping), d = kDamping * w;
  const double p = std::numbers::pi / kPulse_s, re = w * w - p * p, im = 2 * d * p, norm = re * re + im * im;
  const double f = kResidue_per_kg * kForce_N;
  // steady part Im(f e^{jpt}/(re + j im)), and the free part that cancels it and its slope at t = 0
  const double sa = f * re / norm, sb = -f * im / norm;  // sin and cos amplitudes
  const double c1 = -sb, c2 = (-sa * p + d * c1) / wd;
  const double e = std::exp(-d * t_s), s = std::sin(wd * t_s), c = std::cos(wd * t_s);
  const double free = e * (c1 * c + c2 * s), free1 = e * ((-d * c1 + wd * c2) * c + (-d * c2 - wd * c1) * s);
  State out{.x = sa * std::sin(p * t_s) + sb * std::cos(p * t_s) + free,
            .v = p * (sa * std::cos(p * t_s) - sb * std::sin(p * t_s)) + free1};
  out.a = f * std::sin(p * t_s) - 2 * d * out.v - w * w * out.x;
  return out;
}

Impact impact(double fs_Hz = 20000, double rest_s = 0.1, double length_s = 1.2) {
  Impact out{.fs_Hz = fs_Hz, .onset_s = rest_s + 0.37 / fs_Hz};
  for (std::size_t i = 0; i < static_cast<std::size_t>(length_s * fs_Hz); ++i) {
    const double t = static_cast<double>(i) / fs_Hz - out.onset_s;
    const State on = started_sine(t), off = started_sine(t - kPulse_s);
    out.force_N.push_back(t > 0 && t < kPulse_s ? kForce_N * std::sin(std::numbers::pi * t / kPulse_s) : 0);
    out.accel_mps2.push_back(on.a + off.a);
    out.deflection_m.push_back(on.x + off.x);
  }
  return out;
}

ImpactSignal signal_of(const Impact& test) {
  return {.fs_Hz = test.fs_Hz, .accel_mps2 = test.accel_mps2, .onset_s = test.onset_s, .force_N = {}, .modes = {}};
}

// The force has corners, so its samples are not band-limited. Aliasing changes its integral by (Δt/T)²·π²/12.
constexpr double kFine_Hz = 200000;
constexpr double kAliasing = 2.5e-6;

TEST(Deflection, IsExactForACleanRecord) {
  const Impact test = impact(kFine_Hz, 0.02, 0.3);
  const Deflection found = deflection_of(signal_of(test));
  EXPECT_EQ(found.method, DeflectionMethod::drift_free);
  EXPECT_NEAR(std::abs(found.peak_m), test::largest_magnitude(test.deflection_m),
              kAliasing * test::largest_magnitude(test.deflection_m));
  // The relative error of the velocity after the pulse, kAliasing, makes an error of the deflection that grows with
  // time: to ωt = 25 times kAliasing of the peak in 0.28 s.
  for (std::size_t i = 0; i < test.deflection_m.size(); i += 500)
    EXPECT_NEAR(found.deflection_m[i], test.deflection_m[i],
                30 * kAliasing * test::largest_magnitude(test.deflection_m))
        << i;
}

// Behind an anti-alias filter, the deflection is the filtered one. The reference follows from the filtered force, not
// from the samples of the acceleration.
TEST(Deflection, IsExactForAFilteredRecordAtEverySamplingRate) {
  // Of the peak: kMethodError of deflection.cpp, the error by rounding and by the filter's first ringing.
  constexpr double kTolerance = 1e-6;
  const std::vector<synth::SynthPole> poles{{14.5, 0.012}, {90, 0.01}, {322, 0.008}};
  for (const double fs_Hz : {2000.0, 5000.0, 12800.0, 25600.0, 50000.0}) {
    const auto samples = static_cast<std::size_t>(1.2 * fs_Hz);
    const synth::PulseBasis basis =
        synth::pulse_basis({.onset_s = 0.1, .width_s = 0.0025, .peak_N = 800}, fs_Hz, poles, 0, samples);
    std::vector<double> force(samples), accel(samples);
    std::copy(basis.force_N.begin(), basis.force_N.end(), force.begin() + static_cast<std::ptrdiff_t>(basis.first));
    std::vector<ModalContribution> modes;
    for (std::size_t m = 0; m < poles.size(); ++m) {
      modes.push_back(
          {.pole = {poles[m].freq_Hz, poles[m].damping_ratio}, .residue_per_kg = 1.0 + static_cast<double>(m)});
      for (std::size_t i = 0; i < samples - basis.first; ++i) {
        const double regular = i < basis.regular_N[m].size() ? basis.regular_N[m][i] : 0;
        accel[basis.first + i] += modes.back().residue_per_kg.real() * (regular + force[basis.first + i]);
      }
    }
    const auto truth = modal_deflection(force, fs_Hz, modes, 0).deflection_m;
    const Deflection found =
        deflection_of({.fs_Hz = fs_Hz, .accel_mps2 = accel, .onset_s = 0.1, .force_N = {}, .modes = {}});
    EXPECT_NEAR(std::abs(found.peak_m), test::largest_magnitude(truth), kTolerance * test::largest_magnitude(truth))
        << fs_Hz;
  }
}

TEST(Deflection, RemovesBiasAndDriftWithinItsStandardDeviation) {
  const Impact clean = impact();
  std::mt19937 random(5);
  std::normal_distribution<double> gauss;
  double sum = 0;
  std::size_t count = 0;
  for (int trial = 0; trial < 20; ++trial) {
    Impact test = clean;
    const double bias = gauss(random), drift = 0.2 * gauss(random);
    for (std::size_t i = 0; i < test.accel_mps2.size(); ++i)
      test.accel_mps2[i] += bias + drift * static_cast<double>(i) / test.fs_Hz + 0.3 * gauss(random);
    const Deflection found = deflection_of(signal_of(test));
    EXPECT_TRUE(found.zero_mean_corrected);
    EXPECT_NEAR(std::abs(found.peak_m), test::largest_magnitude(test.deflection_m),
                0.002 * test::largest_magnitude(test.deflection_m));
    for (std::size_t i = 2100; i < test.deflection_m.size(); i += 1000, ++count) {
      const double z = (found.deflection_m[i] - test.deflection_m[i]) / found.std_m[i];
      EXPECT_LE(std::abs(z), 4.5);  // 20 records, some 20 samples of each
      sum += z * z;
    }
  }
  // The stated standard deviation is not too small. It is too large late in a record, because it neglects that the
  // zero-mean correction removes part of the noise.
  EXPECT_LE(std::sqrt(sum / static_cast<double>(count)), 1.2);
  EXPECT_GE(std::sqrt(sum / static_cast<double>(count)), 0.2);
}

// A short rest hardly determines the bias. Before the record ends, the parabola of its error exceeds the oscillation.
TEST(Deflection, DoesNotReportARandomWalkAsThePeak) {
  const Impact clean = impact(20000, 0.005);
  std::mt19937 random(7);
  std::normal_distribution<double> gauss;
  for (int trial = 0; trial < 60; ++trial) {
    Impact test = clean;
    for (double& a : test.accel_mps2) a += 3 * gauss(random);
    const Deflection found = deflection_of(signal_of(test), {.free_body = true});
    EXPECT_LE(std::abs(found.peak_m), 2 * test::largest_magnitude(test.deflection_m)) << trial;
    EXPECT_NEAR(found.peak_m, test.deflection_m[found.peak], 4.5 * found.peak_std_m) << trial;
    EXPECT_LE(found.peak_std_m, std::abs(found.peak_m) / 4) << trial;
    EXPECT_GT(found.std_m.back(), test::largest_magnitude(test.deflection_m)) << trial;
  }
}

TEST(Deflection, HasNoPeakInNoise) {
  std::mt19937 random(8);
  std::normal_distribution<double> gauss;
  int with_peak = 0;
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<double> noise(4000);
    for (double& a : noise) a = gauss(random);
    const ImpactSignal signal{.fs_Hz = 20000, .accel_mps2 = noise, .onset_s = 0.1, .force_N = {}, .modes = {}};
    const Deflection found = deflection_of(signal);
    with_peak += std::isnan(found.peak_m) ? 0 : 1;
    EXPECT_EQ(std::isnan(found.peak_m), std::isnan(found.peak_std_m));
  }
  // A peak must exceed four standard deviations, which a random walk does in one of 200 records.
  EXPECT_LE(with_peak, 3);
}

TEST(Deflection, KeepsTheRigidBodyMotionOfAFreeBody) {
  Impact test = impact();
  const double mass_kg = 0.9;
  double v = 0, w = 0;
  for (std::size_t i = 0; i < test.accel_mps2.size(); ++i) {
    test.accel_mps2[i] += test.force_N[i] / mass_kg;
    test.deflection_m[i] += w;
    v += test.force_N[i] / mass_kg / test.fs_Hz;
    w += v / test.fs_Hz;
  }
  ImpactSignal signal = signal_of(test);
  const Deflection unknown = deflection_of(signal, {.free_body = true});
  EXPECT_NEAR(unknown.deflection_m.back(), test.deflection_m.back(), 1e-3 * std::abs(test.deflection_m.back()));
  EXPECT_FALSE(
      deflection_of(signal).zero_mean_corrected);  // the motion does not return, which contradicts a held structure
  signal.force_N = test.force_N;
  signal.rigid_per_kg = 1 / mass_kg;
  const Deflection known = deflection_of(signal);
  EXPECT_TRUE(known.zero_mean_corrected);
  EXPECT_NEAR(known.deflection_m.back(), test.deflection_m.back(), 1e-3 * std::abs(test.deflection_m.back()));
}

TEST(Deflection, FromModesNeedsNoRestBeforeTheImpact) {
  Impact test = impact(20000, 0.0001);
  for (double& a : test.accel_mps2) a += 5;
  ImpactSignal signal = signal_of(test);
  signal.force_N = test.force_N;
  signal.modes = {{.pole = pole(), .residue_per_kg = kResidue_per_kg}};
  const Deflection found = deflection_of(signal);
  EXPECT_EQ(found.method, DeflectionMethod::modal);
  EXPECT_NEAR(std::abs(found.peak_m), test::largest_magnitude(test.deflection_m),
              1e-3 * test::largest_magnitude(test.deflection_m));
}

// A free body moves away; the modes alone cannot show it. A held structure has no rigid-body motion.
TEST(Deflection, FromModesSaysThatItLeavesOutRigidBodyMotion) {
  Impact test = impact();
  ImpactSignal signal = signal_of(test);
  signal.force_N = test.force_N;
  signal.modes = {{.pole = pole(), .residue_per_kg = kResidue_per_kg}};
  EXPECT_FALSE(deflection_of(signal, {.method = DeflectionMethod::modal}).rigid_motion_left_out);
  const double mass_kg = 0.9;
  for (std::size_t i = 0; i < test.accel_mps2.size(); ++i) test.accel_mps2[i] += test.force_N[i] / mass_kg;
  signal.accel_mps2 = test.accel_mps2;
  EXPECT_TRUE(deflection_of(signal, {.method = DeflectionMethod::modal}).rigid_motion_left_out);
  signal.rigid_per_kg = 1 / mass_kg;
  EXPECT_FALSE(deflection_of(signal, {.method = DeflectionMethod::modal}).rigid_motion_left_out);
}

// A bat hung on rubber bands moves freely only during a part of the suspension's period; afterwards the bands pull it
// back.
TEST(Deflection, FromModesContradictsAFreeBodyThatASuspensionPullsBack) {
  constexpr double kFs_Hz = 12800, kMass_kg = 0.25;
  constexpr std::size_t kSamples = 7680;  // 0.6 s
  const std::vector<synth::SynthPole> poles{{3, 0.05}, {170, 0.005}};
  const synth::PulseBasis basis =
      synth::pulse_basis({.onset_s = 0.1, .width_s = 0.001, .peak_N = 250}, kFs_Hz, poles, 0, kSamples);
  std::vector<double> force(kSamples), hung(kSamples), free(kSamples);
  std::copy(basis.force_N.begin(), basis.force_N.end(), force.begin() + static_cast<std::ptrdiff_t>(basis.first));
  std::mt19937 random(3);
  std::normal_distribution<double> gauss;
  for (std::size_t i = 0; i < kSamples; ++i) {
    hung[i] = free[i] = 0.3 + 0.3 * gauss(random);
    if (i < basis.first) continue;
    const std::size_t k = i - basis.first;
    const auto by_pole = [&](std::size_t m) { return k < basis.regular_N[m].size() ? basis.regular_N[m][k] : 0; };
    hung[i] += (force[i] + by_pole(0)) / kMass_kg + 3 * (force[i] + by_pole(1));
    free[i] += force[i] / kMass_kg + 3 * (force[i] + by_pole(1));
  }
  const ModalContribution bending{.pole = {170, 0.005}, .residue_per_kg = 3};
  const ModalContribution suspension{.pole = {3, 0.05}, .residue_per_kg = 1 / kMass_kg};
  ImpactSignal signal{.fs_Hz = kFs_Hz,
                      .accel_mps2 = hung,
                      .onset_s = 0.1,
                      .force_N = force,
                      .rigid_per_kg = 1 / kMass_kg,
                      .modes = {bending}};
  const Deflection found = deflection_of(signal, {.method = DeflectionMethod::modal});
  const auto truth = modal_deflection(force, kFs_Hz, {bending, suspension}, 0).deflection_m;
  EXPECT_TRUE(found.rigid_motion_contradicted);
  EXPECT_NEAR(found.peak_m, truth[found.peak], 3 * found.peak_std_m);
  EXPECT_NEAR(found.deflection_m.back(), truth.back(), 3 * found.std_m.back());
  EXPECT_FALSE(
      deflection_of(signal, {.method = DeflectionMethod::modal, .moves_before = true}).rigid_motion_contradicted);
  signal.accel_mps2 = free;
  EXPECT_FALSE(deflection_of(signal, {.method = DeflectionMethod::modal}).rigid_motion_contradicted);
}

// A body that moves away has no largest deflection. The peak is then the value that exceeds four times its ± by most.
TEST(Deflection, SaysThatTheMotionGoesOnAfterTheLargestValue) {
  Impact test = impact(20000, 0.005);
  EXPECT_FALSE(deflection_of(signal_of(impact()), {}).larger_later);
  std::mt19937 random(7);
  std::normal_distribution<double> gauss;
  for (std::size_t i = 0; i < test.accel_mps2.size(); ++i) test.accel_mps2[i] += 2 * test.force_N[i] + gauss(random);
  const Deflection found = deflection_of(signal_of(test), {.free_body = true});
  EXPECT_LT(found.peak + 1, found.deflection_m.size());
  EXPECT_TRUE(found.larger_later);
  for (double& a : test.accel_mps2) a = -a;  // a sensor the other way round
  const Deflection reversed = deflection_of(signal_of(test), {.free_body = true});
  EXPECT_EQ(reversed.peak, found.peak);
  EXPECT_EQ(std::abs(reversed.peak_m), std::abs(found.peak_m));
}

// The same impact by the method modal, with exact modes.
Deflection by_exact_modes(const Impact& test, double force_noise_N = 0, double gain_std = 0) {
  ImpactSignal signal = signal_of(test);
  signal.force_N = test.force_N;
  signal.force_noise_N = force_noise_N;
  signal.modes = {{.pole = pole(), .residue_per_kg = kResidue_per_kg, .gain_std = gain_std}};
  return deflection_of(signal, {.method = DeflectionMethod::modal});
}

TEST(Deflection, FromModesDoesNotTakeNoiseForMissingMotion) {
  Impact test = impact();
  constexpr double kNoise = 0.1;  // over the rms of the acceleration
  double squares = 0;
  for (const double a : test.accel_mps2) squares += a * a;
  std::mt19937 engine(1);
  std::normal_distribution<double> normal(0, kNoise * std::sqrt(squares / static_cast<double>(test.accel_mps2.size())));
  for (double& a : test.accel_mps2) a += normal(engine);
  const Deflection found = by_exact_modes(test);
  // The sum of N products of noise samples scatters by σ²√N. Its root is kNoise/12 of the motion; the limit is twice
  // that.
  EXPECT_LT(found.peak_std_m, kNoise / 6 * std::abs(found.peak_m));
}

TEST(Deflection, FromModesCountsMotionThatTheModesDoNotExplain) {
  Impact test = impact();
  constexpr double kMissing = 0.1;
  for (double& a : test.accel_mps2) a *= 1 + kMissing;
  const Deflection found = by_exact_modes(test);
  // The unexplained share comes from products of neighbouring samples, which differ at the corners of the pulse: it is
  // a little too small.
  EXPECT_NEAR(found.peak_std_m / std::abs(found.peak_m), kMissing, 0.05 * kMissing);
}

TEST(Deflection, FromModesMovesAllModesByTheCommonGain) {
  const Impact test = impact(kFine_Hz, 0.02, 0.3);
  constexpr double kGain = 0.01;
  ImpactSignal signal = signal_of(test);
  signal.force_N = test.force_N;
  const ModalContribution half{.pole = pole(), .residue_per_kg = kResidue_per_kg / 2, .gain_std = kGain};
  signal.modes = {half, half};
  const Deflection found = deflection_of(signal, {.method = DeflectionMethod::modal});
  EXPECT_NEAR(found.peak_std_m / std::abs(found.peak_m), kGain, 1e-3 * kGain);
}

TEST(Deflection, FromModesScattersByTheNoiseOfTheForceAsItsStandardDeviationStates) {
  constexpr double kNoise_N = 5;
  constexpr int kRepeats = 100;
  const Impact clean = impact(5000, 0.02, 0.3);
  const Deflection stated = by_exact_modes(clean, kNoise_N);
  std::mt19937 engine(1);
  std::normal_distribution<double> normal(0, kNoise_N);
  double squares = 0;
  for (int i = 0; i < kRepeats; ++i) {
    Impact test = clean;
    for (double& f : test.force_N) f += f != 0 ? normal(engine) : 0;
    squares += std::pow(by_exact_modes(test).deflection_m[stated.peak] - stated.peak_m, 2);
  }
  // A standard deviation from 100 values scatters by 7 %; the limit is three times that.
  EXPECT_NEAR(std::sqrt(squares / kRepeats) / stated.peak_std_m, 1, 0.21);
}

TEST(Deflection, ConvergesAtFirstOrderBySmallIntervals) {
  std::vector<double> errors;
  for (const double fs_Hz : {5000.0, 10000.0, 20000.0}) {
    const Impact test = impact(fs_Hz);
    const Deflection found = deflection_of(signal_of(test), {.method = DeflectionMethod::small_interval});
    errors.push_back(std::abs(found.deflection_m.back() - test.deflection_m.back()));
  }
  EXPECT_GT(errors[0], 1.6 * errors[1]);
  EXPECT_GT(errors[1], 1.6 * errors[2]);
}

TEST(Deflection, IsRightInTheFrequencyDomainForARecordThatComesToRest) {
  const Impact test = impact(4000, 2, 10);
  const Deflection found = deflection_of(signal_of(test), {.method = DeflectionMethod::frequency, .lowest_Hz = 0.4});
  // Motion slower than lowest_Hz is lost: a few per cent of a decay with ζω = 1.1/s.
  EXPECT_NEAR(std::abs(found.peak_m), test::largest_magnitude(test.deflection_m),
              0.03 * test::largest_magnitude(test.deflection_m));
}

TEST(MotionOnset, IsWhereTheMotionBegins) {
  const Impact test = impact();
  EXPECT_NEAR(motion_onset_s(test.accel_mps2, test.fs_Hz), test.onset_s, 5 / test.fs_Hz);
}

TEST(BaselineEstimate, RecoversBiasDriftAndNoise) {
  std::vector<double> before(400);
  for (int i = 0; i < 400; ++i)
    before[static_cast<std::size_t>(i)] = 2 + 0.5 * (i - 400) / 1000.0 + (i % 2 == 0 ? 0.1 : -0.1);
  const BaselineEstimate rest = baseline_estimate(before, 1000, 1);
  EXPECT_NEAR(rest.bias(0), 2, 0.02);
  EXPECT_NEAR(rest.bias(1), 0.5, 0.1);
  EXPECT_NEAR(rest.noise_mps2, 0.1, 0.001);
}

// A filter that settles at the start of a record is no impact.
TEST(MotionOnset, IsNotAGlitchAtTheStart) {
  std::vector<double> x(3000);
  std::mt19937 random(1);
  std::normal_distribution<double> gauss;
  for (std::size_t n = 0; n < x.size(); ++n) {
    x[n] = 0.3 * gauss(random) + (n < 6 ? 6.0 * (n % 2 == 0 ? 1 : -1) : 0);
    if (n >= 2000) x[n] += 2000 * std::sin(0.01 * static_cast<double>(n - 2000));
  }
  EXPECT_NEAR(motion_onset_s(x, 20000), 0.1, 2e-4);
}

// Noise whose power falls from 30 Hz on, as in a micro-machined sensor. Its mean over the rest scatters far more than
// the mean of white noise with the same rms. The ± of bias and drift must include this.
TEST(BaselineEstimate, StatesTheScatterOfColouredNoise) {
  constexpr double kFs_Hz = 20000, kPole = 0.99;
  double squares = 0, white_noise = 0;
  constexpr unsigned kSeeds = 60;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> gauss;
    std::vector<double> coloured(4000), white(4000);
    double now = 0;
    for (int n = 0; n < 2000; ++n) now = kPole * now + gauss(random);
    for (std::size_t n = 0; n < coloured.size(); ++n) {
      coloured[n] = now = kPole * now + gauss(random);
      white[n] = gauss(random);
    }
    const BaselineEstimate rest = baseline_estimate(coloured, kFs_Hz, 1);
    squares += rest.bias(0) * rest.bias(0) / rest.covariance(0, 0);
    white_noise += baseline_estimate(white, kFs_Hz, 1).noise_mps2 / kSeeds;
  }
  EXPECT_GT(std::sqrt(squares / kSeeds), 0.4);
  EXPECT_LT(std::sqrt(squares / kSeeds), 1.6);  // it would be 14 if the noise were taken for white
  EXPECT_NEAR(white_noise, 1, 0.01);
}

TEST(BaselineEstimate, IsZeroForFewSamples) {
  const BaselineEstimate rest = baseline_estimate(std::vector<double>(5, 7.0), 1000, 20);
  EXPECT_EQ(rest.bias(0), 0);
  EXPECT_NEAR(std::sqrt(rest.covariance(0, 0)), 2, 1e-12);
}

// The acceleration of a sway of 1.2 Hz passes zero before the impact and follows a straight line there. If this line is
// taken for bias and drift, the error of the deflection grows to about 2 m in two seconds. The stated level of the
// sensor shows that the line is motion.
TEST(Deflection, DoesNotContinueTheLineOfASlowSway) {
  Impact swaying = impact(20000, 0.1, 2.1);
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 1e-3);
  constexpr double kSway_mps2 = 0.19, kSway_radps = kTwoPi * 1.2;
  for (std::size_t i = 0; i < swaying.accel_mps2.size(); ++i) {
    const double t = static_cast<double>(i) / swaying.fs_Hz - 0.05;
    swaying.accel_mps2[i] += kSway_mps2 * std::sin(kSway_radps * t) + noise(random);
  }
  ImpactSignal signal{.fs_Hz = swaying.fs_Hz, .accel_mps2 = swaying.accel_mps2, .onset_s = swaying.onset_s};
  const DeflectionOptions options{.method = DeflectionMethod::drift_free, .free_body = true};
  const Deflection continued = deflection_of(signal, options);
  EXPECT_GT(std::abs(continued.peak_m), 0.5);
  signal.level = SensorLevel{.mps2 = 0, .std_mps2 = 1e-4};
  const Deflection found = deflection_of(signal, options);
  EXPECT_TRUE(found.moved_before);
  EXPECT_LT(found.peak_std_m, 0.02);
  const double truth_m = test::largest_magnitude(swaying.deflection_m);
  constexpr double kSway_m = kSway_mps2 / (kSway_radps * kSway_radps);
  EXPECT_LT(std::abs(std::abs(found.peak_m) - truth_m), kSway_m + 3 * found.peak_std_m);
}

}  // namespace percuss::metrics::deflection_test
