#include "identify/fit/local_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/modal_frfs.hpp"

namespace percuss::identify::local_fit_test {

using Eigen::VectorXd;

const std::vector<Complex> kResidues{{0.8, 0.1}, {-0.3, 0.02}};

/// Two channels, one mode at 300.37 Hz of 1 %, on a parabolic background.
FrfDataset one_mode() {
  FrfDataset set = test::empty_set(4096, 32768, 270, 330, 2);
  for (std::size_t o = 0; o < 2; ++o) {
    test::add_mode(set, o, {300.37, 0.01}, kResidues[o]);
    for (std::size_t k = 0; k < set.lines.count; ++k) {
      const double x = static_cast<double>(k) / static_cast<double>(set.lines.count);
      set.channels[o].frf[k] += Complex(0.5, 2) + Complex(-1, 3) * x + Complex(2, 0.4) * x * x;
    }
  }
  return set;
}

LocalFit fit(const FrfDataset& set, std::vector<Pole> start, const VectorXd& weight = VectorXd::Ones(2)) {
  return fit_locally(set, test::frf_vectors(set), weight, std::move(start), {.first = 0, .count = set.lines.count});
}

TEST(FitLocally, IsExactOnLinesWithoutNoise) {
  constexpr double kTolerance = 1e-10;  // rounding of 1e-13 times a condition number of some hundred
  const LocalFit found = fit(one_mode(), {{300.9, 0.014}});
  EXPECT_TRUE(found.converged);
  EXPECT_LE(std::abs(found.poles[0].freq_Hz / 300.37 - 1), kTolerance);
  EXPECT_LE(std::abs(found.poles[0].damping_ratio / 0.01 - 1), 100 * kTolerance);
  for (Eigen::Index o = 0; o < 2; ++o)
    EXPECT_LE(std::abs(found.residues(o, 0) - kResidues[static_cast<std::size_t>(o)]), 100 * kTolerance);
  EXPECT_LE(found.noise.maxCoeff(), 1e-9 * 40);  // of the peak, 40 (m/s²)/N
}

TEST(FitLocally, Separates2ModesAHalfPowerBandwidthApart) {
  constexpr double kTolerance = 1e-8;  // rounding, amplified by the overlap
  FrfDataset set = test::empty_set(4096, 32768, 270, 330, 2);
  const std::vector<Pole> truth{{298, 0.01}, {304, 0.012}};
  for (std::size_t o = 0; o < 2; ++o) {
    test::add_mode(set, o, truth[0], kResidues[o]);
    test::add_mode(set, o, truth[1], std::conj(kResidues[1 - o]));
  }
  const LocalFit found = fit(set, {{297, 0.008}, {305.5, 0.01}});
  for (std::size_t m = 0; m < 2; ++m) {
    EXPECT_LE(std::abs(found.poles[m].freq_Hz - truth[m].freq_Hz), kTolerance * 300);
    EXPECT_LE(std::abs(found.poles[m].damping_ratio - truth[m].damping_ratio), kTolerance);
  }
}

TEST(FitLocally, CountsItsDegreesOfFreedom) {
  const FrfDataset set = one_mode();
  // 4 real values per line; 2 for the pole and 2 · 2 · (1 residue + 3 coefficients).
  EXPECT_EQ(fit(set, {{300, 0.01}}).degrees, 4 * set.lines.count - 18);
}

TEST(FitLocally, FindsTheNoiseOfEachFrf) {
  constexpr double kTolerance = 0.1;  // four standard deviations of an rms over 480 complex lines (2.3 %)
  FrfDataset set = one_mode();
  test::add_frf_noise(set, 0.03, 5);
  const LocalFit found = fit(set, {{300, 0.01}});
  for (Eigen::Index o = 0; o < 2; ++o) EXPECT_LE(std::abs(found.noise(o) / (0.03 * std::sqrt(2)) - 1), kTolerance);
}

TEST(FitLocally, ScalesWithTheDataAndNotWithTheWeights) {
  constexpr double kTolerance = 1e-7;  // where the iteration stops
  FrfDataset set = one_mode();
  test::add_frf_noise(set, 0.03, 9);
  const LocalFit a = fit(set, {{300, 0.01}});
  for (FrfChannel& channel : set.channels) {
    for (Complex& line : channel.frf) line *= Complex(0, -1e6);
  }
  const LocalFit b = fit(set, {{300, 0.01}}, VectorXd::Constant(2, 40));
  EXPECT_LE(std::abs(a.poles[0].freq_Hz / b.poles[0].freq_Hz - 1), kTolerance);
  EXPECT_LE(std::abs(a.freq_std_Hz(0) / b.freq_std_Hz(0) - 1), kTolerance);
  EXPECT_LE(std::abs(a.damping_std(0) / b.damping_std(0) - 1), kTolerance);
  EXPECT_LE(std::abs(b.residues(0, 0) / a.residues(0, 0) - Complex(0, -1e6)), kTolerance * 1e6);
  EXPECT_LE(std::abs(b.residue_std(1, 0) / a.residue_std(1, 0) - 1e6), kTolerance * 1e6);
}

TEST(FitLocally, StatesTheStandardDeviationsOf200Repetitions) {
  constexpr int kRuns = 200;
  constexpr double kTolerance = 0.2;  // four standard deviations of a standard deviation from 200 values (5 %)
  constexpr double kBias = 0.3;       // of a standard deviation: four standard deviations of a mean of 200 values
  VectorXd square = VectorXd::Zero(4), sum = VectorXd::Zero(4), stated = VectorXd::Zero(4);
  for (int run = 0; run < kRuns; ++run) {
    FrfDataset set = one_mode();
    test::add_frf_noise(set, 0.05, static_cast<std::uint64_t>(run) + 100);
    const LocalFit found = fit(set, {{300, 0.01}});
    const Complex residue = found.residues(0, 0) - kResidues[0];
    const Eigen::Vector4d error(found.poles[0].freq_Hz - 300.37, found.poles[0].damping_ratio - 0.01, residue.real(),
                                residue.imag());
    sum += error;
    square += error.cwiseAbs2();
    stated +=
        Eigen::Vector4d(found.freq_std_Hz(0), found.damping_std(0), found.residue_std(0, 0), found.residue_std(0, 0));
  }
  const VectorXd scatter = (square / kRuns).cwiseSqrt();
  for (Eigen::Index i = 0; i < 2; ++i) {
    EXPECT_LE(std::abs(scatter(i) * kRuns / stated(i) - 1), kTolerance) << i;
    EXPECT_LE(std::abs(sum(i) / stated(i)), kBias) << i;
  }
  // The standard deviation of a residue is the RMS of the standard deviations of its real and imaginary parts.
  EXPECT_LE(std::abs(std::hypot(scatter(2), scatter(3)) / std::sqrt(2) * kRuns / stated(2) - 1), kTolerance);
}

TEST(FitLocally, KeepsItsStartWithoutData) {
  const FrfDataset set = test::empty_set(4096, 32768, 270, 330, 2);
  const LocalFit found = fit(set, {{300, 0.01}});
  EXPECT_EQ(found.poles[0].freq_Hz, 300);
  EXPECT_EQ(found.residues(0, 0), Complex());
  EXPECT_TRUE(std::isfinite(found.freq_std_Hz(0)));
}

TEST(PoleOfWindow, IsNearlyExactOnASingleMode) {
  // (a + b jω)/(jω − s) approximates (jω)²/((jω)² + …) to about (bandwidth/frequency)².
  constexpr double kTolerance = 2e-3;
  FrfDataset set = test::empty_set(4096, 32768, 290, 310, 2);
  for (std::size_t o = 0; o < 2; ++o) test::add_mode(set, o, {300.37, 0.01}, kResidues[o]);
  const Pole found = pole_of_window(set, test::frf_vectors(set), 0);
  EXPECT_LE(std::abs(found.freq_Hz / 300.37 - 1), 0.1 * kTolerance);
  EXPECT_LE(std::abs(found.damping_ratio / 0.01 - 1), 10 * kTolerance);
}

TEST(PoleOfWindow, IsZeroWithoutADecayingMode) {
  FrfDataset set = test::empty_set(4096, 32768, 290, 310, 1);
  EXPECT_EQ(pole_of_window(set, test::frf_vectors(set), 0).freq_Hz, 0);
  test::add_mode(set, 0, {300, 0.01}, {1, 0});
  for (Complex& line : set.channels[0].frf) line = std::conj(line);  // grows instead of decaying
  EXPECT_EQ(pole_of_window(set, test::frf_vectors(set), 0).freq_Hz, 0);
}

}  // namespace percuss::identify::local_fit_test
