#include "model/bat/structure_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "model/bat/bat_modes.hpp"
#include "synth/random_stream.hpp"

namespace percuss::model::structure_fit_test {

constexpr double kFound = 1e-7;  // relative: the fit ends with steps of 1e-9. Measured: 5e-9 of parameters

// A wood bat on a spring, with a cap.
BeamStructure held_bat() {
  BeamStructure bat{.table = {.kind = ProfileKind::points}, .material = {}};
  for (const auto& [at_m, diameter_m] : {std::pair{0.0, 0.045}, std::pair{0.03, 0.026}, std::pair{0.4, 0.028},
                                         std::pair{0.6, 0.06}, std::pair{0.84, 0.066}})
    bat.table.stations.push_back({.at_m = at_m, .width_m = diameter_m, .layers = {{}}});
  bat.added = {{.mass_kg = 0.04, .from_m = 0.84, .to_m = 0.84}};
  bat.support = {.kind = BeamSupport::torsion, .at_m = 0.1524, .torsion_Nmprad = 800};
  return bat;
}

std::vector<MeasuredMode> measured_on(const BeamStructure& bat, std::size_t modes, double relative_std) {
  const BatModes solved = bat_modes(bat, {.modes = modes});
  std::vector<MeasuredMode> measured;
  for (std::size_t i = 0; i < modes; ++i) {
    const double f_Hz = solved.freq_Hz[static_cast<Eigen::Index>(i)];
    measured.push_back({.elastic = i, .freq_Hz = f_Hz, .std_Hz = relative_std * f_Hz});
  }
  return measured;
}

TEST(StructureFit, RecoversStiffnessSpringAndMassFromExactFrequencies) {
  const BeamStructure truth = held_bat();
  const auto measured = measured_on(truth, 5, 1e-4);
  BeamStructure start = truth;
  start.material.young_Pa *= 0.7;
  start.support.torsion_Nmprad *= 20;
  start.added[0].mass_kg *= 3;
  const StructureFit fit = fit_structure(
      start, {StructureParameter::young, StructureParameter::torsion, StructureParameter::mass}, measured);
  EXPECT_NEAR(fit.parameters[0].value / truth.material.young_Pa, 1, kFound);
  EXPECT_NEAR(fit.parameters[1].value / 800, 1, kFound);
  EXPECT_NEAR(fit.parameters[2].value / 0.04, 1, kFound);
  // Measured 7e-12: the effects of the remaining errors of the parameters nearly cancel in the frequencies.
  constexpr double kFitted = 1e-9;
  for (std::size_t i = 0; i < measured.size(); ++i) EXPECT_NEAR(fit.model_Hz[i] / measured[i].freq_Hz, 1, kFitted);
}

// Frequencies of a slender beam rise with √E: σ_E/E = 2 σ_f/f for one frequency, and 2 σ_f/(f √n) for n.
TEST(StructureFit, StatesTheClosedFormOfAStandardDeviation) {
  BeamStructure beam = held_bat();
  beam.slender = true;
  beam.support = {};
  for (const std::size_t modes : {1U, 4U}) {
    const StructureFit fit = fit_structure(beam, {StructureParameter::young}, measured_on(beam, modes, 1e-3));
    const double expected = 2e-3 / std::sqrt(static_cast<double>(modes));
    constexpr double kDifferences = 1e-6;  // of the fit's central differences in log E; measured 6e-7
    EXPECT_NEAR(*fit.parameters[0].std / fit.parameters[0].value, expected, kDifferences * expected);
  }
}

// Two frequencies, 6 standard deviations above and below the model: χ² is 72 for one degree of freedom.
TEST(StructureFit, EnlargesStandardDeviationsThatTheMisfitExceeds) {
  BeamStructure beam = held_bat();
  beam.slender = true;
  beam.support = {};
  auto measured = measured_on(beam, 2, 1e-3);
  const double stated = *fit_structure(beam, {StructureParameter::young}, measured).parameters[0].std;
  measured[0].freq_Hz *= 1 + 6e-3;
  measured[1].freq_Hz *= 1 - 6e-3;
  const StructureFit fit = fit_structure(beam, {StructureParameter::young}, measured);
  constexpr double kFrequenciesChanged = 0.02;  // a standard deviation in Hz is another part of the changed frequency
  EXPECT_NEAR(std::sqrt(fit.chi2 / 72), 1, kFrequenciesChanged);
  EXPECT_NEAR(*fit.parameters[0].std / stated / std::sqrt(72), 1, kFrequenciesChanged);
}

// Noisy frequencies scatter the fitted values as widely as their stated standard deviations say.
TEST(StructureFit, StatesTheScatterOfItsValues) {
  const BeamStructure truth = held_bat();
  const auto exact = measured_on(truth, 4, 1e-3);
  const std::vector<StructureParameter> fitted{StructureParameter::young, StructureParameter::mass};
  const std::vector<double> values{truth.material.young_Pa, 0.04};
  constexpr int kDraws = 40;
  synth::RandomStream random({0x5717, 1});
  std::vector<double> squares(2, 0);
  for (int draw = 0; draw < kDraws; ++draw) {
    auto noisy = exact;
    for (MeasuredMode& one : noisy) {
      std::array<double, 1> x{one.freq_Hz};
      random.add_normal(one.std_Hz, x);
      one.freq_Hz = x[0];
    }
    const StructureFit fit = fit_structure(truth, fitted, noisy, {.max_element_fraction = 1.0 / 40});
    for (std::size_t i = 0; i < 2; ++i)
      squares[i] += std::pow((fit.parameters[i].value - values[i]) / *fit.parameters[i].std, 2) / kDraws;
  }
  // The mean of 40 squares has a standard deviation of √(2/40) = 0.22; the bounds are three of them below and four
  // above.
  for (const double square : squares) {
    EXPECT_GT(square, 0.3);
    EXPECT_LT(square, 1.9);
  }
}

TEST(StructureFit, HoldsTheTotalMass) {
  const BeamStructure truth = held_bat();
  const double total_kg = inertia_of(timoshenko_beam(truth, 0.01)).mass_kg;
  BeamStructure start = truth;
  start.added[0].mass_kg = 0.02;
  start.material.density_kgpm3 = density_for_mass(start, total_kg);
  const StructureFit fit = fit_structure(start, {StructureParameter::young, StructureParameter::mass},
                                         measured_on(truth, 4, 1e-3), {.total_mass_kg = total_kg});
  EXPECT_NEAR(fit.parameters[1].value / 0.04, 1, kFound);
  EXPECT_NEAR(fit.structure.material.density_kgpm3 / truth.material.density_kgpm3, 1, kFound);
}

TEST(StructureFit, HasNoStandardDeviationWithoutSpareFrequencies) {
  const BeamStructure bat = held_bat();
  EXPECT_FALSE(fit_structure(bat, {StructureParameter::young}, measured_on(bat, 1, 0)).parameters[0].std.has_value());
  EXPECT_TRUE(fit_structure(bat, {StructureParameter::young}, measured_on(bat, 2, 0)).parameters[0].std.has_value());
}

// A slender free beam without an added mass determines E/ρ only.
TEST(StructureFit, RefusesWhatFrequenciesDoNotDetermine) {
  BeamStructure beam = held_bat();
  beam.slender = true;
  beam.support = {};
  beam.added.clear();
  EXPECT_THROW(
      fit_structure(beam, {StructureParameter::young, StructureParameter::density}, measured_on(beam, 4, 1e-3)),
      InputError);
}

}  // namespace percuss::model::structure_fit_test
