#include "model/beam/beam_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.hpp"

namespace percuss::model::beam_fit_test {

using enum BeamParameter;

const UniformBeam kTruth{.stiffness_Nm2 = 3100, .mass_per_length_kgpm = 1.7, .torsion_Nmprad = 2300, .length_m = 0.62};

std::vector<MeasuredFrequency> measured(const UniformBeam& beam, std::size_t from, std::size_t count) {
  std::vector<MeasuredFrequency> out;
  const auto modes = beam_modes(beam, from + count);
  for (std::size_t i = from; i < modes.size(); ++i) out.push_back({.mode = i, .freq_Hz = modes[i].freq_Hz()});
  return out;
}

constexpr double kFound = 1e-8;  // relative: rounding of the frequencies, 1e-15, amplified by small sensitivities

TEST(BeamFit, RecoversTheParametersOfItsFrequencies) {
  for (const auto& asked : std::vector<std::vector<BeamParameter>>{{stiffness},
                                                                   {torsion},
                                                                   {mass_per_length},
                                                                   {stiffness, torsion},
                                                                   {stiffness, mass_per_length},
                                                                   {mass_per_length, torsion}}) {
    UniformBeam start = kTruth;
    for (const BeamParameter which : asked) {
      if (which == stiffness) start.stiffness_Nm2 = 70;
      if (which == torsion) start.torsion_Nmprad = 4e4;
      if (which == mass_per_length) start.mass_per_length_kgpm = 90;
    }
    const BeamFit fit = fit_beam(start, asked, measured(kTruth, 0, 4));
    EXPECT_NEAR(fit.beam.stiffness_Nm2 / kTruth.stiffness_Nm2, 1, kFound) << asked.size();
    EXPECT_NEAR(fit.beam.torsion_Nmprad / kTruth.torsion_Nmprad, 1, kFound);
    EXPECT_NEAR(fit.beam.mass_per_length_kgpm / kTruth.mass_per_length_kgpm, 1, kFound);
  }
}

TEST(BeamFit, RecoversTheStiffnessOfFreeAndTimoshenkoBeams) {
  UniformBeam beam = kTruth;
  beam.support = BeamSupport::free;
  beam.gyration_m = 0.01;
  beam.shear_stiffness_N = 3e6;
  UniformBeam start = beam;
  start.stiffness_Nm2 = 500;
  EXPECT_NEAR(fit_beam(start, {stiffness}, measured(beam, 2, 3)).beam.stiffness_Nm2 / 3100, 1, kFound);
  start = beam;
  start.mass_per_length_kgpm = 20;
  EXPECT_NEAR(fit_beam(start, {mass_per_length}, measured(beam, 2, 3)).beam.mass_per_length_kgpm / 1.7, 1, kFound);
}

TEST(BeamFit, ReproducesAsManyFrequenciesAsUnknowns) {
  const BeamFit fit = fit_beam(kTruth, {stiffness, torsion}, {{.mode = 0, .freq_Hz = 20}, {.mode = 1, .freq_Hz = 300}});
  constexpr double kReproduced = 1e-10;  // relative; measured 2e-16
  EXPECT_NEAR(fit.model_Hz[0] / 20, 1, kReproduced);
  EXPECT_NEAR(fit.model_Hz[1] / 300, 1, kReproduced);
  EXPECT_FALSE(fit.parameters[0].std.has_value());
}

TEST(BeamFit, FlagsASpringThatActsAsAClamp) {
  const double clamped_Hz = beam_modes({.support = BeamSupport::clamped}, 1)[0].freq_Hz();
  EXPECT_TRUE(fit_beam({}, {torsion}, {{.mode = 0, .freq_Hz = 2 * clamped_Hz}}).at_limit);
  EXPECT_FALSE(fit_beam({}, {torsion}, {{.mode = 0, .freq_Hz = 0.5 * clamped_Hz}}).at_limit);
}

// With noise of known size, the scatter of the fitted values matches the stated standard deviations.
TEST(BeamFit, StatesTheStandardDeviationsOfItsScatter) {
  constexpr int kRuns = 400;
  constexpr double kRelative = 1e-3;
  const auto truth = measured(kTruth, 0, 4);
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  double known = 0, from_residuals = 0, pull = 0;
  for (int run = 0; run < kRuns; ++run) {
    auto noisy = truth;
    for (auto& one : noisy) one.freq_Hz *= 1 + kRelative * normal(random);
    const BeamFit unweighted = fit_beam(kTruth, {stiffness, torsion}, noisy);
    from_residuals += std::pow(*unweighted.parameters[1].std / unweighted.parameters[1].value, 2) / kRuns;
    for (auto& one : noisy) one.std_Hz = kRelative * one.freq_Hz;
    const BeamFit fit = fit_beam(kTruth, {stiffness, torsion}, noisy);
    known = *fit.parameters[1].std;
    pull += std::pow((fit.parameters[1].value - kTruth.torsion_Nmprad) / known, 2) / kRuns;
  }
  constexpr double kSpread = 0.25;  // 3.5 standard deviations of a mean of 400 squares
  EXPECT_NEAR(pull, 1, kSpread);
  EXPECT_NEAR(std::sqrt(from_residuals) / (known / kTruth.torsion_Nmprad), 1, kSpread);
}

// The frequencies differ from the model by six of their standard deviations. The standard deviation of the stiffness
// includes this misfit: it grows by √χ² (one degree of freedom).
TEST(BeamFit, EnlargesStandardDeviationsThatTheMisfitExceeds) {
  UniformBeam beam = kTruth;
  beam.support = BeamSupport::free;
  auto known = measured(beam, 2, 2);
  for (auto& one : known) one.std_Hz = 1e-3 * one.freq_Hz;
  const double small = *fit_beam(beam, {stiffness}, known).parameters[0].std;
  known[0].freq_Hz *= 1 + 6e-3;
  known[1].freq_Hz *= 1 - 6e-3;
  auto unknown = known;
  for (auto& one : unknown) one.std_Hz = 0;
  const BeamFit fit = fit_beam(beam, {stiffness}, known);
  constexpr double kOfRelativeStd = 0.02;  // the standard deviations are no longer exactly 1e-3 of the frequencies
  EXPECT_NEAR(*fit.parameters[0].std / small, std::sqrt(fit.chi2), kOfRelativeStd * std::sqrt(fit.chi2));
  EXPECT_NEAR(*fit.parameters[0].std / *fit_beam(beam, {stiffness}, unknown).parameters[0].std, 1, kOfRelativeStd);
}

TEST(StaticTorsion, IncludesTheBendingOfTheBeam) {
  // d = P a²/T + P a³/(3 EI), written out.
  const auto read = [](double load_N, double lever_m) {
    return StaticReading{load_N, lever_m,
                         load_N * lever_m * lever_m / 1200 + load_N * std::pow(lever_m, 3) / (3 * 4000)};
  };
  constexpr double kRounding_Nmprad = 1e-9;  // 1e-12 of the value
  const TorsionFit one = fit_torsion({read(25, 0.4)}, 4000);
  EXPECT_NEAR(one.torsion_Nmprad, 1200, kRounding_Nmprad);
  EXPECT_FALSE(one.std_Nmprad.has_value());
  const TorsionFit several = fit_torsion({read(25, 0.4), read(50, 0.4), read(50, 0.55)}, 4000);
  EXPECT_NEAR(several.torsion_Nmprad, 1200, kRounding_Nmprad);
  EXPECT_NEAR(*several.std_Nmprad, 0, kRounding_Nmprad);
}

TEST(StaticTorsion, StatesTheStandardDeviationOfItsScatter) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  constexpr int kRuns = 2000;
  double spread = 0, stated = 0;
  for (int run = 0; run < kRuns; ++run) {
    std::vector<StaticReading> readings;
    for (int i = 1; i <= 6; ++i) {
      const double load_N = 10 * i;
      readings.push_back({load_N, 0.5, load_N * (0.25 / 1200 + 0.125 / 12000) + 2e-5 * normal(random)});
    }
    const TorsionFit fit = fit_torsion(readings, 4000);
    spread += std::pow(fit.torsion_Nmprad - 1200, 2) / kRuns;
    stated += *fit.std_Nmprad * *fit.std_Nmprad / kRuns;
  }
  EXPECT_NEAR(stated / spread, 1, 0.15);  // 3.5 standard deviations of the ratio of two means of 2000 squares
}

TEST(StaticTorsion, RefusesDeflectionsBelowTheBending) {
  EXPECT_THROW(fit_torsion({{.load_N = 10, .lever_m = 0.5, .deflection_m = 1e-5}}, 4000), InputError);
}

}  // namespace percuss::model::beam_fit_test
