#include "identify/fit/joint_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/modal_frfs.hpp"
#include "synth/cramer_rao_bound.hpp"
#include "synth/synthesise.hpp"

namespace percuss::identify::joint_fit_test {

const std::vector<Pole> kTruth{{300.3, 0.01}, {305, 0.012}, {420, 0.006}};
const std::vector<Pole> kStart{{300.6, 0.011}, {304.7, 0.011}, {420.4, 0.0065}};

FrfDataset three_modes(std::size_t channels, Complex turn = 1) {
  FrfDataset set = test::empty_set(4096, 32768, 250, 500, channels);
  for (std::size_t o = 0; o < channels; ++o) {
    const auto x = static_cast<double>(o);
    test::add_mode(set, o, kTruth[0], turn * (0.5 - 0.3 * x));
    test::add_mode(set, o, kTruth[1], turn * (0.2 + 0.4 * x));
    test::add_mode(set, o, kTruth[2], 0.6 - 0.9 * x);
  }
  return set;
}

TEST(FitJointly, IsExactOnLinesWithoutNoise) {
  constexpr double kTolerance = 1e-11;  // rounding errors of 1e-13 times a condition number of about a hundred
  const FrfDataset set = three_modes(2);
  const JointFit fit = fit_jointly(set, kStart);
  EXPECT_TRUE(fit.converged);
  for (std::size_t m = 0; m < 3; ++m) {
    EXPECT_LE(std::abs(fit.poles[m].freq_Hz / kTruth[m].freq_Hz - 1), kTolerance) << m;
    EXPECT_LE(std::abs(fit.poles[m].damping_ratio / kTruth[m].damping_ratio - 1), 100 * kTolerance) << m;
  }
  EXPECT_LE(std::abs(fit.residues(1, 2) + 0.3), 1e3 * kTolerance);
}

TEST(FitJointly, LeavesHeldPolesAndFitsTheOthers) {
  const FrfDataset set = three_modes(2);
  JointFitOptions options;
  options.held = {{420, 0.006}};
  const JointFit fit = fit_jointly(set, {kStart[0], kStart[1], options.held[0]}, options);
  EXPECT_TRUE(fit.converged);
  EXPECT_EQ(fit.poles[2], options.held[0]);
  for (std::size_t m = 0; m < 2; ++m)
    EXPECT_LE(std::abs(fit.poles[m].freq_Hz / kTruth[m].freq_Hz - 1), 1e-12) << m << ": the held pole is right";
  EXPECT_GT(fit.freq_std_Hz(2), 0);
}

// A weak mode of 4 % damping near the first line: its damping is known to a fifth. The rounding of the cost then hides
// steps that are larger than the fit's tolerance.
TEST(FitJointly, ConvergesWithAModeThatTheLinesHardlyDetermine) {
  FrfDataset clean = test::empty_set(4096, 8192, 8, 975, 1);
  const std::vector<Pole> truth{{24.3, 0.04}, {47.8, 0.025}, {131.2, 0.012}, {412, 0.005}};
  const std::vector<double> residues{-4e-4, 5e-3, 1e-2, 0.02};
  for (std::size_t m = 0; m < truth.size(); ++m) test::add_mode(clean, 0, truth[m], residues[m]);
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    FrfDataset set = clean;
    test::add_frf_noise(set, 1e-3, seed);
    EXPECT_TRUE(fit_jointly(set, truth).converged) << seed;
  }
}

// Mean squares of the errors, in units of the reported standard deviations, over many realisations of the noise: of all
// poles, and of one residue. Also the number of modes with a complex residue.
struct Scatter {
  double freq = 0, damping = 0, residue = 0;
  int complex_modes = 0;
};

// The fit may exchange close poles.
std::size_t nearest(const std::vector<Pole>& poles, const Pole& truth) {
  const auto closer = [&](const Pole& a, const Pole& b) {
    return std::abs(a.freq_Hz - truth.freq_Hz) < std::abs(b.freq_Hz - truth.freq_Hz);
  };
  return static_cast<std::size_t>(std::min_element(poles.begin(), poles.end(), closer) - poles.begin());
}

Scatter scatter(Complex turn, double noise, int seeds) {
  Scatter out;
  const FrfDataset clean = three_modes(2, turn);
  for (int seed = 0; seed < seeds; ++seed) {
    FrfDataset set = clean;
    test::add_frf_noise(set, noise, static_cast<std::uint64_t>(seed));
    const JointFit fit = fit_jointly(set, kStart);
    for (const Pole& truth : kTruth) {
      const std::size_t m = nearest(fit.poles, truth);
      const auto i = static_cast<Eigen::Index>(m);
      out.freq += std::pow((fit.poles[m].freq_Hz - truth.freq_Hz) / fit.freq_std_Hz(i), 2) / (3 * seeds);
      out.damping += std::pow((fit.poles[m].damping_ratio - truth.damping_ratio) / fit.damping_std(i), 2) / (3 * seeds);
      out.complex_modes += fit.real[m] ? 0 : 1;
    }
    out.residue += std::pow((fit.residues(0, 2).real() - 0.6) / fit.residue_std(0, 2), 2) / seeds;
  }
  return out;
}

TEST(FitJointly, StatesTrueStandardDeviations) {
  // The mean square of 300 values (correlated within a pair) scatters by about 0.1. The tolerance is four times that.
  constexpr double kTolerance = 0.4;
  for (const Complex turn : {Complex(1, 0), Complex(0.8, 0.6)}) {
    const Scatter all = scatter(turn, 0.5, 100);
    EXPECT_LE(std::abs(all.freq - 1), kTolerance) << turn;
    EXPECT_LE(std::abs(all.damping - 1), kTolerance) << turn;
    EXPECT_LE(std::abs(all.residue - 1), 1.5 * kTolerance) << turn;
  }
}

TEST(FitJointly, KeepsAllResiduesRealUnlessTheDataContradict) {
  EXPECT_EQ(scatter(1, 0.5, 40).complex_modes, 0);
  // The pair has complex residues. The third mode's are real, but one mode with complex residues makes all complex.
  EXPECT_EQ(scatter(Complex(0.8, 0.6), 0.5, 40).complex_modes, 120);
}

TEST(FitJointly, DetectsFrfsWithDifferentPhases) {
  FrfDataset set = test::empty_set(4096, 32768, 250, 400, 2);
  test::add_mode(set, 0, kTruth[0], Complex(0.5, 0.3));
  test::add_mode(set, 1, kTruth[0], Complex(0.5, -0.3));
  test::add_frf_noise(set, 0.1, 1);
  const JointFit fit = fit_jointly(set, {kStart[0]});
  EXPECT_FALSE(fit.real[0]);
  EXPECT_LE(std::abs(fit.residues(1, 0) - Complex(0.5, -0.3)), 5 * fit.residue_std(1, 0));
}

TEST(FitJointly, MeetsTheBoundOfATruncatedRecord) {
  // The modes need more than the recorded 0.6 s to decay. The bound comes from the exact time series, not from the
  // model of the fit. The tolerance is a tenth, because the fit uses neither the lines outside the band nor the part of
  // the response that is orthogonal to the force.
  synth::SynthSpec spec = test::bat_spec({{.freq_Hz = 180, .damping_ratio = 0.004, .residue_per_kg = {0.9, 0.5}},
                                          {.freq_Hz = 600, .damping_ratio = 0.003, .residue_per_kg = {-0.7, 0.8}}},
                                         0.6);
  spec.noise = {.force = 0, .accel = 1e-2};
  const synth::SyntheticTest made = synth::synthesise(spec);
  const FrfDataset set = test::frf_set_of(made.record, 30, 2400);
  const JointFit fit = fit_jointly(set, {{180.1, 0.0042}, {600.2, 0.0031}});
  const synth::CramerRaoBound bound = synth::cramer_rao_bound(made.truth);
  for (std::size_t m = 0; m < 2; ++m) {
    const auto i = static_cast<Eigen::Index>(m);
    EXPECT_TRUE(fit.real[m]);
    EXPECT_LE(std::abs(fit.freq_std_Hz(i) / bound.freq_std_Hz[m] - 1), 0.1) << m;
    EXPECT_LE(std::abs(fit.damping_std(i) / bound.damping_ratio_std[m] - 1), 0.1) << m;
  }
}

}  // namespace percuss::identify::joint_fit_test
