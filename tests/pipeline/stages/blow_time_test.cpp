#include "pipeline/stages/blow_time.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.hpp"
#include "pipeline/analysis.hpp"

// FRFs of records that begin before the blow and end while modes ring, from the closed form of their transform.
namespace percuss::pipeline::blow_time_test {

// Records of 1 s. Of the amplitudes, 41 to 3 % are left at their end (38 to 2 % where the record begins with the blow).
constexpr double kLength_s = 1, kBeforeBlow_s = 0.0803;
const std::vector<identify::Pole> kPoles{{61.3, 0.0025}, {143.7, 0.002}, {391.9, 0.0012}, {612.4, 0.001}};
constexpr std::size_t kSeeds = 10;
// The RMS of 40 normal numbers (four modes of ten tests) is known to 11 %; the limits are three times as far.
constexpr double kMinRms = 0.67, kMaxRms = 1.33;
constexpr double kNoise = 3e-4;  // of the largest value at 1/kg

// ∫₀^length_s of (c exp(st) + conj) exp(−jωt), the accelerance's impulse response times exp(−jωt): the FRF (3.2) less
// the missing part.
Complex truncated_accelerance(const identify::Pole& pole, double freq_Hz, double length_s) {
  const double omega = kTwoPi * pole.freq_Hz, zeta = pole.damping_ratio;
  const Complex jw(0, kTwoPi * freq_Hz), s = omega * Complex(-zeta, std::sqrt(1 - zeta * zeta));
  const Complex c = s * s / Complex(0, 2 * s.imag());
  const auto missing = [&](Complex amplitude, Complex rate) {
    return amplitude * std::exp((rate - jw) * length_s) / (jw - rate);
  };
  return jw * jw / (jw * jw + 2 * zeta * omega * jw + omega * omega) - missing(c, s) -
         missing(std::conj(c), std::conj(s));
}

double residue(std::size_t point, std::size_t mode) { return std::cos(1 + 2.3 * static_cast<double>(point * mode)); }

// The FRFs of four points. Their noise grows by this factor over the band, as under a soft pulse.
acquire::FrfRecord record_of(std::uint64_t seed, double ringing_s, double noise_growth = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  acquire::FrfRecord record;
  std::vector<double> freq_Hz;
  for (int k = 10; k <= 800; ++k) freq_Hz.push_back(k / kLength_s);
  record.lines = acquire::lines_from_frequencies(freq_Hz, "test");
  record.accel.push_back({.name = "accel"});
  for (std::size_t p = 0; p < 4; ++p) {
    acquire::Frf frf;
    for (const double f : freq_Hz) {
      Complex h;
      for (std::size_t m = 0; m < kPoles.size(); ++m)
        h += residue(p, m) * truncated_accelerance(kPoles[m], f, ringing_s);
      const double noise = 500 * kNoise * std::pow(noise_growth, f / freq_Hz.back());
      frf.value.push_back(h + noise / std::sqrt(2.0) * Complex(normal(random), normal(random)));
    }
    record.frfs.push_back({.point = static_cast<int>(p), .channel = 0, .frf = std::move(frf)});
  }
  return record;
}

TEST(BlowTime, IsFoundFromTheSilenceBeforeTheBlow) {
  double freq = 0, damping = 0;
  std::size_t modes = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Analysis analysis(record_of(seed, kLength_s - kBeforeBlow_s), {});
    ASSERT_EQ(analysis.modes().size(), kPoles.size()) << seed;
    for (std::size_t m = 0; m < kPoles.size(); ++m) {
      const identify::Mode& mode = analysis.modes()[m];
      freq += std::pow((mode.pole.freq_Hz - kPoles[m].freq_Hz) / mode.freq_std_Hz, 2);
      damping += std::pow((mode.pole.damping_ratio - kPoles[m].damping_ratio) / mode.damping_std, 2);
      ++modes;
    }
  }
  const double freq_rms = std::sqrt(freq / static_cast<double>(modes));
  const double damping_rms = std::sqrt(damping / static_cast<double>(modes));
  EXPECT_GT(freq_rms, kMinRms);
  EXPECT_LT(freq_rms, kMaxRms);
  EXPECT_GT(damping_rms, kMinRms);
  EXPECT_LT(damping_rms, kMaxRms);
}

TEST(BlowTime, IsFoundUnderASoftPulse) {
  const Analysis analysis(record_of(1, kLength_s - kBeforeBlow_s, 30), {});
  ASSERT_EQ(analysis.modes().size(), kPoles.size());
  for (std::size_t m = 0; m < kPoles.size(); ++m) {
    const identify::Mode& mode = analysis.modes()[m];
    EXPECT_NEAR(mode.pole.damping_ratio, kPoles[m].damping_ratio, 4 * mode.damping_std) << m;
    EXPECT_LT(mode.damping_std, 0.01 * kPoles[m].damping_ratio) << m << ": without the time, a misfit widens it";
  }
}

// Where the records begin with the blow, all lines of the FRF change by one factor.
TEST(BlowTime, IsNotFoundWhereTheRecordsBeginWithTheBlow) {
  for (const double ringing_s : {kLength_s, 1000.0}) {
    const Analysis analysis(record_of(1, ringing_s), {});
    EXPECT_EQ(analysis.modes().size(), kPoles.size());
    EXPECT_EQ(time_before_blow_s(analysis.fitted_frfs(), analysis.modes()), std::nullopt) << ringing_s;
  }
}

}  // namespace percuss::pipeline::blow_time_test
