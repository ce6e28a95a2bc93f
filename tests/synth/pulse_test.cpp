#include "synth/pulse.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <string>

#include "core/math/fft.hpp"
#include "synth/anti_alias_filter.hpp"

namespace percuss::synth::pulse_test {

constexpr double kFs_Hz = 25600;

/// Five-point Gauss rule on panels of a quarter sample: the phases of the integrands change by less than 0.4 rad from a
/// panel's middle to its edge, which limits the error to about 1e-13.
double integral(double from, double to, const std::function<double(double)>& f) {
  static constexpr std::array kX{-0.906179845938664, -0.538469310105683, 0.0, 0.538469310105683, 0.906179845938664};
  static constexpr std::array kW{0.236926885056189, 0.478628670499366, 0.568888888888889, 0.478628670499366,
                                 0.236926885056189};
  if (to <= from) return 0;
  const int panels = static_cast<int>(std::ceil((to - from) * 4));
  const double half = (to - from) / panels / 2;
  double sum = 0;
  for (int p = 0; p < panels; ++p) {
    for (std::size_t k = 0; k < kX.size(); ++k) sum += half * kW[k] * f(from + half * (2 * p + 1 + kX[k]));
  }
  return sum;
}

double at(const PulseBasis& basis, const std::vector<double>& values, std::size_t sample) {
  const std::size_t i = sample - basis.first;
  return sample >= basis.first && i < values.size() ? values[i] : 0;
}

double peak(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0,
                         [](double m, double v) { return std::max(m, std::abs(v)); });
}

/// The integral of the force over all time.
double impulse_Ns(const Pulse& pulse) {
  constexpr double kPi = std::numbers::pi;
  const double mean = pulse.kind == PulseKind::halfsine    ? 2 / kPi
                      : pulse.kind == PulseKind::haversine ? 0.5
                                                           : 4 / (3 * kPi);
  return mean * pulse.peak_N * pulse.width_s;
}

class EveryPulse : public testing::TestWithParam<PulseKind> {};

TEST_P(EveryPulse, ImpulseIsTheIntegralOfItsForce) {
  const Pulse pulse{GetParam(), 0, 10, 3};  // 10 s, because the panels of `integral` are 1/4 wide
  constexpr double kTolerance = 1e-12;      // error of the quadrature
  EXPECT_LE(std::abs(integral(0, 10, [&](double t) { return pulse_force_N(pulse, t); }) - impulse_Ns(pulse)),
            kTolerance);
  EXPECT_EQ(pulse_force_N(pulse, 5), 3);
  EXPECT_EQ(pulse_force_N(pulse, -1e-9), 0);
  EXPECT_EQ(pulse_force_N(pulse, 10.001), 0);
}

TEST_P(EveryPulse, KeepsItsImpulseInTheFilter) {
  const Pulse pulse{GetParam(), 0.0051337, 0.35e-3, 250};
  const PulseBasis basis = pulse_basis(pulse, kFs_Hz, {}, 0, 1024);
  const double sum = std::accumulate(basis.force_N.begin(), basis.force_N.end(), 0.0) / kFs_Hz;
  constexpr double kTolerance = 1e-13;  // rounding: the filter passes 0 Hz exactly and stops its first alias, fs
  EXPECT_LE(std::abs(sum / impulse_Ns(pulse) - 1), kTolerance);
}

TEST_P(EveryPulse, MatchesANumericalConvolution) {
  const double onset = 130.37, width = 7.7;  // samples
  const Pulse pulse{GetParam(), onset / kFs_Hz, width / kFs_Hz, 1};
  const SynthPole pole{1900, 0.02};
  const PulseBasis basis = pulse_basis(pulse, kFs_Hz, std::array{pole}, 0, 1024);
  const double omega = kTwoPi * pole.freq_Hz / kFs_Hz, sigma = pole.damping_ratio * omega;
  const double damped = std::sqrt(omega * omega - sigma * sigma);
  // Second derivative of e^−σt sin(ω_d t)/ω_d without its impulse at 0.
  const auto impulse_response = [&](double t) {
    return std::exp(-sigma * t) *
           ((sigma * sigma - damped * damped) * std::sin(damped * t) / damped - 2 * sigma * std::cos(damped * t));
  };
  const auto shape = [&](double v) { return pulse_force_N(pulse, v / kFs_Hz); };
  const auto response = [&](double tau) {
    return integral(0, std::min(tau, width), [&](double v) { return impulse_response(tau - v) * shape(v); });
  };
  constexpr double kTolerance = 1e-11;  // of the peak: error of the quadrature in this test
  for (const std::size_t n : {100U, 130U, 134U, 138U, 160U, 201U, 203U, 260U}) {
    const double t = static_cast<double>(n) - onset, from = std::max(0.0, t - kFilterHalfWidth),
                 to = t + kFilterHalfWidth;
    const auto filtered = [&](double tau) { return anti_alias_kernel(t - tau) * response(tau); };
    const double modal = integral(from, std::min(width, to), filtered) + integral(std::max(from, width), to, filtered);
    const double force =
        integral(from, std::min(width, to), [&](double tau) { return anti_alias_kernel(t - tau) * shape(tau); });
    EXPECT_LE(std::abs(at(basis, basis.regular_N[0], n) - modal), kTolerance * peak(basis.regular_N[0])) << n;
    EXPECT_LE(std::abs(at(basis, basis.force_N, n) - force), kTolerance) << n;
  }
}

std::string name_of(const testing::TestParamInfo<PulseKind>& parameter) {
  if (parameter.param == PulseKind::halfsine) return "Halfsine";
  return parameter.param == PulseKind::haversine ? "Haversine" : "SineCubed";
}

INSTANTIATE_TEST_SUITE_P(Pulse, EveryPulse,
                         testing::Values(PulseKind::halfsine, PulseKind::haversine, PulseKind::sine_cubed), name_of);

TEST(Pulse, LeavesPureExponentials) {
  const SynthPole pole{575, 0.006};
  const PulseBasis basis = pulse_basis({PulseKind::halfsine, 0.005, 0.4e-3, 300}, kFs_Hz, std::array{pole}, 0, 20000);
  const double omega = kTwoPi * pole.freq_Hz / kFs_Hz, decay = std::exp(-pole.damping_ratio * omega);
  const double turn = std::cos(omega * std::sqrt(1 - pole.damping_ratio * pole.damping_ratio));
  const std::vector<double>& a = basis.regular_N[0];
  const double tolerance = 1e-14 * peak(a);  // rounding of three terms
  for (std::size_t n = 300; n + 1 < a.size(); ++n) {
    ASSERT_LE(std::abs(a[n + 1] - 2 * decay * turn * a[n] + decay * decay * a[n - 1]), tolerance) << n;
  }
}

TEST(Pulse, TruncatesADecayOnlyBelowRounding) {
  const PulseBasis basis =
      pulse_basis({PulseKind::halfsine, 0.005, 0.4e-3, 300}, kFs_Hz, std::array{SynthPole{2000, 0.05}}, 0, 20000);
  EXPECT_LT(basis.regular_N[0].size(), 5000U);
  constexpr double kTruncated = 1e-17;  // of the peak: a tenth of the rounding of a double
  EXPECT_LE(std::abs(basis.regular_N[0].back()), kTruncated * peak(basis.regular_N[0]));
}

TEST(Pulse, DoesNotDependOnTheRangeOfSamples) {
  const Pulse pulse{PulseKind::haversine, 0.005, 0.3e-3, 300};
  const std::array poles{SynthPole{169, 0.01}, SynthPole{1900, 0.003}};
  const PulseBasis whole = pulse_basis(pulse, kFs_Hz, poles, 0, 4096);
  constexpr double kTolerance = 1e-13;  // of the peak: exponentials start at another sample and round differently
  for (const std::size_t first : {100U, 130U, 150U, 1000U}) {
    const PulseBasis part = pulse_basis(pulse, kFs_Hz, poles, first, 500);
    EXPECT_GE(part.first, first);
    for (std::size_t r = 0; r < poles.size(); ++r) {
      const double tolerance = kTolerance * peak(whole.regular_N[r]);
      for (std::size_t n = first; n < first + 500; ++n) {
        ASSERT_LE(std::abs(at(part, part.regular_N[r], n) - at(whole, whole.regular_N[r], n)), tolerance) << n;
      }
    }
  }
}

TEST(Pulse, RingsAfterAnOnsetBeforeTheFirstSample) {
  const std::array poles{SynthPole{169, 0.01}};
  const PulseBasis before_record = pulse_basis({PulseKind::haversine, -0.02, 0.3e-3, 300}, kFs_Hz, poles, 0, 1024);
  const PulseBasis within_record = pulse_basis({PulseKind::haversine, 0.02, 0.3e-3, 300}, kFs_Hz, poles, 0, 4096);
  EXPECT_EQ(peak(before_record.force_N), 0);
  constexpr double kTolerance = 1e-12;  // of the peak: the onsets differ by 0.04 s, exactly 1024 samples
  EXPECT_LE(std::abs(before_record.regular_N[0][500] - at(within_record, within_record.regular_N[0], 1524)),
            kTolerance * peak(before_record.regular_N[0]));
}

TEST(AntiAliasFilter, IsFlatInTheBandAndStopsItsImage) {
  std::vector<double> kernel(8192, 0.0);  // eight values a sample, so that frequencies to 4 fs show
  for (int i = -512; i <= 512; ++i)
    kernel[static_cast<std::size_t>((i + 8192) % 8192)] = anti_alias_kernel(i / 8.0) / 8;
  const std::vector<Complex> gain = real_dft(kernel);
  constexpr double kTolerance = 2e-12;  // the Gaussian's tail seven standard deviations from the cut-off
  for (std::size_t k = 0; k < gain.size(); ++k) {
    const double freq = static_cast<double>(k) / 1024;  // cycles per sample
    if (freq <= 0.30) {
      EXPECT_LE(std::abs(gain[k] - 1.0), kTolerance) << freq;
    }
    if (freq >= 0.60) {
      EXPECT_LE(std::abs(gain[k]), kTolerance) << freq;
    }
  }
}

}  // namespace percuss::synth::pulse_test
