#include "model/bat/beam_structure.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/error.hpp"
#include "model/bat/bat_modes.hpp"

namespace percuss::model::beam_structure_test {

using std::numbers::pi;

// The relative tolerance of a frequency, above the error of the elements at the fourth mode. kFine has at least 160
// elements; with 84, the error is 2e-6 at the sixth mode (bat_modes_test.cpp).
constexpr double kElementError = 1e-6;
constexpr BatModesOptions kFine{.modes = 6, .max_element_fraction = 1.0 / 160};

BeamStructure rectangle(double length_m, double width_m, double thickness_m) {
  return {.table = {.round = false,
                    .stations = {{.at_m = length_m, .width_m = width_m, .layers = {{.thickness_m = thickness_m}}}}},
          .material = {},
          .slender = true};
}

// Expects that `equation` changes its sign within ± kElementError of f_Hz: f_Hz is a root of it.
void expect_root(double f_Hz, const std::function<double(double)>& equation, const char* what) {
  EXPECT_NE(std::signbit(equation(f_Hz * (1 - kElementError))), std::signbit(equation(f_Hz * (1 + kElementError))))
      << what << " " << f_Hz;
}

double determinant(const Eigen::Matrix4d& m) {
  Eigen::Matrix4d scaled = m;
  for (Eigen::Index c = 0; c < 4; ++c) scaled.col(c).normalize();
  return scaled.determinant();
}

// A beam whose thickness grows as the distance x from its virtual tip; its width is constant (wedge, n = 1) or grows as
// well (cone, n = 2). The solutions are x^(−n/2) C_n(2 κ √x) with C = J, Y, I, K, κ⁴ = ρA ω²/EI at x = 1:
//   w′ = ∓κ x^(−(n+1)/2) C_(n+1), w″ = κ² x^(−(n+2)/2) C_(n+2), (x^(n+2) w″)′ = ±κ³ x^((n+1)/2) C_(n+1)
class Tapered {
 public:
  Tapered(int n, double near_m, double far_m, double mass_over_stiffness)
      : n_(n), near_m_(near_m), far_m_(far_m), mass_over_stiffness_(mass_over_stiffness) {}

  double clamped_at_the_thick_end(double f_Hz) const {
    Eigen::Matrix4d m;
    m << row(f_Hz, far_m_, 0), row(f_Hz, far_m_, 1), row(f_Hz, near_m_, 2), row(f_Hz, near_m_, 3);
    return determinant(m);
  }
  double free(double f_Hz) const {
    Eigen::Matrix4d m;
    m << row(f_Hz, far_m_, 2), row(f_Hz, far_m_, 3), row(f_Hz, near_m_, 2), row(f_Hz, near_m_, 3);
    return determinant(m);
  }

 private:
  // what: 0 deflection, 1 slope, 2 moment, 3 shear force, without common factors.
  Eigen::RowVector4d row(double f_Hz, double x, int what) const {
    const double kappa = std::pow(mass_over_stiffness_, 0.25) * std::sqrt(2 * pi * f_Hz), z = 2 * kappa * std::sqrt(x);
    const double order = n_ + (what == 0 ? 0 : what == 2 ? 2 : 1);
    const double plus = what == 1 ? -1 : 1;  // sign for J and Y; in the slope it is opposite to the sign for I
    return {plus * std::cyl_bessel_j(order, z), plus * std::cyl_neumann(order, z), std::cyl_bessel_i(order, z),
            (what == 1 || what == 3 ? -1 : 1) * std::cyl_bessel_k(order, z)};
  }

  int n_;
  double near_m_, far_m_, mass_over_stiffness_;  // ρA/EI at x = 1
};

// Points along a beam from its thick end, 0.5 m from the virtual tip, to a distance of 0.1 m from the tip.
constexpr double kThickEnd_m = 0.5, kThinEnd_m = 0.1;  // from the tip to which the taper points
constexpr double kTaper = 0.08;                        // thickness or diameter per distance from the tip

BeamStructure tapered(bool round) {
  BeamStructure beam{.table = {.kind = ProfileKind::points, .round = round}, .material = {}, .slender = true};
  for (const double x : {kThickEnd_m, 0.37, kThinEnd_m}) {
    beam.table.stations.push_back({.at_m = kThickEnd_m - x,
                                   .width_m = round ? kTaper * x : 0.05,
                                   .layers = {round ? SectionLayer{} : SectionLayer{.thickness_m = kTaper * x}}});
  }
  return beam;
}

TEST(BeamStructure, MatchesBesselFunctionsForAWedgeAndACone) {
  for (const bool round : {false, true}) {
    BeamStructure beam = tapered(round);
    const Material material;
    // I/A = h²/12 of a rectangle, d²/16 of a circle.
    const double gyration2 = kTaper * kTaper / (round ? 16 : 12);
    const Tapered exact(round ? 2 : 1, kThinEnd_m, kThickEnd_m,
                        material.density_kgpm3 / (material.young_Pa * gyration2));
    const BatModes free = bat_modes(beam, kFine);
    beam.support = {.kind = BeamSupport::clamped, .at_m = 0};
    const BatModes held = bat_modes(beam, kFine);
    for (Eigen::Index i = 0; i < 4; ++i) {
      expect_root(
          free.freq_Hz[i], [&](double f) { return exact.free(f); }, "free");
      expect_root(
          held.freq_Hz[i], [&](double f) { return exact.clamped_at_the_thick_end(f); }, "clamped");
    }
  }
}

// The classical values ω L² √(ρA/EI) of a complete wedge and cone, clamped at the base: 5.315 and 8.719 (k²/4, with k
// the roots of J1 I2 + I1 J2 and of J2 I3 + I2 J3). The tip of the model has a ten-thousandth of the base's thickness.
// A tip of a thousandth would lower the values by 0.2 %.
TEST(BeamStructure, ApproachesTheCompleteWedgeAndCone) {
  for (const auto& [round, classical] : {std::pair{false, 5.315}, std::pair{true, 8.719}}) {
    BeamStructure beam{.table = {.kind = ProfileKind::points, .round = round}, .material = {}, .slender = true};
    for (const auto& [at_m, size_m] : {std::pair{0.0, 0.1}, std::pair{1.0, 1e-5}}) {
      beam.table.stations.push_back({.at_m = at_m,
                                     .width_m = round ? size_m : 0.05,
                                     .layers = {round ? SectionLayer{} : SectionLayer{.thickness_m = size_m}}});
    }
    beam.support = {.kind = BeamSupport::clamped, .at_m = 0};
    const BatModes modes = bat_modes(beam, kFine);
    const double gyration = 0.1 / std::sqrt(round ? 16.0 : 12.0);
    const double wave = std::sqrt(beam.material.young_Pa / beam.material.density_kgpm3) * gyration;
    constexpr double kTip = 1e-3;  // the classical values have four digits, and the tip is not a point
    EXPECT_NEAR(2 * pi * modes.freq_Hz[0] / wave, classical, kTip * classical);
  }
}

// The Timoshenko modes of a tube and of a laminate, from the exact solution of the uniform beam.
TEST(BeamStructure, MatchesTheExactTubeAndLaminate) {
  BeamStructure tube{.table = {.stations = {{.at_m = 0.3, .width_m = 0.066, .layers = {{.thickness_m = 0.003}}},
                                            {.at_m = 0.84, .width_m = 0.066, .layers = {{.thickness_m = 0.003}}}}},
                     .material = {.density_kgpm3 = 2700, .young_Pa = 7e10, .shear_Pa = 1.3e10}};
  BeamStructure layered = tube;
  layered.table.round = false;
  const SectionLayer skin{.thickness_m = 0.004, .density_kgpm3 = 1600, .young_Pa = 5e10, .shear_Pa = 3e9};
  for (SectionStation& station : layered.table.stations) station.layers = {skin, {.thickness_m = 0.03}, skin};
  for (const BeamStructure& beam : {tube, layered}) {
    const BeamSection section = section_at(beam.table, beam.material, 0, 0);
    const auto exact = beam_modes({.support = BeamSupport::free,
                                   .stiffness_Nm2 = section.bending_Nm2,
                                   .mass_per_length_kgpm = section.mass_kgpm,
                                   .length_m = 0.84,
                                   .gyration_m = std::sqrt(section.rotary_kgm / section.mass_kgpm),
                                   .shear_stiffness_N = section.shear_N},
                                  6);
    const BatModes modes = bat_modes(beam, kFine);
    for (Eigen::Index i = 0; i < 4; ++i) {
      const double exact_Hz = exact[static_cast<std::size_t>(i) + 2].freq_Hz();
      EXPECT_NEAR(modes.freq_Hz[i], exact_Hz, kElementError * exact_Hz) << i;
    }
  }
}

// A cantilever with a point mass μ ρA L at its tip: 1 + cos λ cosh λ = μ λ (sin λ cosh λ − cos λ sinh λ).
TEST(BeamStructure, MatchesACantileverWithATipMass) {
  BeamStructure beam = rectangle(0.6, 0.05, 0.01);
  beam.support = {.kind = BeamSupport::clamped, .at_m = 0};
  const BeamSection section = section_at(beam.table, beam.material, 0, 0);
  const double plain_kg = section.mass_kgpm * 0.6;
  for (const double ratio : {0.1, 1.0, 10.0}) {
    beam.added = {{.mass_kg = ratio * plain_kg, .from_m = 0.6, .to_m = 0.6}};
    const BatModes modes = bat_modes(beam, kFine);
    const auto equation = [&](double f_Hz) {
      const double l = std::sqrt(2 * pi * f_Hz * std::sqrt(section.mass_kgpm / section.bending_Nm2)) * 0.6;
      return 1 / std::cosh(l) + std::cos(l) - ratio * l * (std::sin(l) - std::cos(l) * std::tanh(l));
    };
    for (Eigen::Index i = 0; i < 3; ++i) expect_root(modes.freq_Hz[i], equation, "tip mass");
  }
}

TEST(BeamStructure, SpreadsAMassEvenly) {
  BeamStructure beam = rectangle(0.6, 0.05, 0.01);
  const BeamSection section = section_at(beam.table, beam.material, 0, 0);
  const BatModes plain = bat_modes(beam, kFine);
  beam.added = {{.mass_kg = 3 * section.mass_kgpm * 0.6, .from_m = 0, .to_m = 0.6}};
  const BatModes loaded = bat_modes(beam, kFine);
  EXPECT_NEAR(loaded.inertia.mass_kg, 4 * plain.inertia.mass_kg, 1e-14);
  for (Eigen::Index i = 0; i < 6; ++i) EXPECT_NEAR(loaded.freq_Hz[i], plain.freq_Hz[i] / 2, 1e-9 * plain.freq_Hz[i]);
}

// The closed form of the uniform beam, whose free end is x = L.
TEST(BeamStructure, MatchesTheUniformBeamOnEachSupport) {
  BeamStructure beam = rectangle(0.57, 0.1, 0.02);
  const BeamSection section = section_at(beam.table, beam.material, 0, 0);
  for (const BeamSupport kind : {BeamSupport::torsion, BeamSupport::pinned, BeamSupport::clamped, BeamSupport::free}) {
    beam.support = {.kind = kind, .at_m = 0, .torsion_Nmprad = 1200};
    const UniformBeam uniform{.support = kind,
                              .stiffness_Nm2 = section.bending_Nm2,
                              .mass_per_length_kgpm = section.mass_kgpm,
                              .torsion_Nmprad = 1200,
                              .length_m = 0.57};
    const std::size_t rigid = rigid_body_modes(kind);
    const auto exact = beam_modes(uniform, rigid + 4);
    const BatModes modes = bat_modes(beam, kFine);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      const BeamMode& mode = exact[rigid + i];
      EXPECT_NEAR(modes.freq_Hz[at], mode.freq_Hz(), kElementError * mode.freq_Hz()) << i;
      const double tip = modes.deflection(0.57)[at];
      EXPECT_NEAR(tip * tip, 1 / (section.mass_kgpm * mode.norm_m), 1e-5 * tip * tip) << i;
      const auto nodes = nodes_of(modes, i), exact_nodes = beam_nodes_m(mode);
      ASSERT_EQ(nodes.size(), exact_nodes.size()) << i;
      for (std::size_t n = 0; n < nodes.size(); ++n) EXPECT_NEAR(nodes[n], exact_nodes[n], 1e-6);
    }
  }
}

// A clamp within the beam leaves two cantilevers, and a mode of one of them has no nodes on the other.
TEST(BeamStructure, IsTwoCantileversAroundAClamp) {
  BeamStructure beam = rectangle(0.9, 0.05, 0.01);
  beam.support = {.kind = BeamSupport::clamped, .at_m = 0.3};
  const BeamSection section = section_at(beam.table, beam.material, 0, 0);
  const auto cantilever = [&](double length_m) {
    return beam_modes({.support = BeamSupport::clamped,
                       .stiffness_Nm2 = section.bending_Nm2,
                       .mass_per_length_kgpm = section.mass_kgpm,
                       .length_m = length_m},
                      3);
  };
  std::vector<double> exact_Hz;
  for (const double length_m : {0.3, 0.6}) {
    for (const BeamMode& mode : cantilever(length_m)) exact_Hz.push_back(mode.freq_Hz());
  }
  std::sort(exact_Hz.begin(), exact_Hz.end());
  const BatModes modes = bat_modes(beam, kFine);
  for (Eigen::Index i = 0; i < 4; ++i)
    EXPECT_NEAR(modes.freq_Hz[i], exact_Hz[static_cast<std::size_t>(i)], kElementError * modes.freq_Hz[i]) << i;
  EXPECT_EQ(nodes_of(modes, 0).size(), 0U);
}

// A hollow bat that tapers between points, with a point mass of 50 g at its end and 30 g spread over its handle.
// Reference: the differential equations of the Timoshenko beam integrated from the knob (scipy's DOP853, relative
// 1e-12), and the roots of the determinant of the boundary conditions; mass and moments by quadrature. Computed without
// percuss.
BeamStructure hollow_bat(BeamSupport kind) {
  BeamStructure bat{.table = {.kind = ProfileKind::points},
                    .material = {.density_kgpm3 = 2700, .young_Pa = 7e10, .shear_Pa = 1.3e10}};
  constexpr std::array<std::array<double, 3>, 4> kRows{
      {{0, 0.028, 0.003}, {0.35, 0.028, 0.003}, {0.6, 0.062, 0.0025}, {0.84, 0.066, 0.0025}}};
  for (const auto& [at_m, diameter_m, wall_m] : kRows)
    bat.table.stations.push_back({.at_m = at_m, .width_m = diameter_m, .layers = {{.thickness_m = wall_m}}});
  bat.added = {{.mass_kg = 0.05, .from_m = 0.84, .to_m = 0.84}, {.mass_kg = 0.03, .from_m = 0, .to_m = 0.3}};
  bat.support = {.kind = kind, .at_m = 0.1524, .torsion_Nmprad = 1500};
  return bat;
}

TEST(BeamStructure, AgreesWithIntegratedEquationsOnEachSupport) {
  const std::vector<std::pair<BeamSupport, std::vector<double>>> reference{
      {BeamSupport::free, {252.1725503, 809.3975186, 1550.157053, 2441.397102}},
      {BeamSupport::torsion, {14.32418145, 258.0186204, 628.4853084, 1249.057393, 2227.089922}},
      {BeamSupport::pinned, {244.6183874, 619.8893399, 1248.362421, 2224.242135}},
      {BeamSupport::clamped, {37.09876125, 398.8287044, 968.6491113, 1299.939292, 2355.513044}}};
  for (const auto& [kind, exact_Hz] : reference) {
    const BatModes modes = bat_modes(hollow_bat(kind), kFine);
    for (std::size_t i = 0; i < exact_Hz.size(); ++i) {
      EXPECT_NEAR(modes.freq_Hz[static_cast<Eigen::Index>(i)], exact_Hz[i], 2 * kElementError * exact_Hz[i])
          << static_cast<int>(kind) << " " << i;
    }
  }
}

TEST(BeamStructure, HasTheMassAndMomentsOfQuadrature) {
  const BatInertia inertia = bat_modes(hollow_bat(BeamSupport::free), kFine).inertia;
  constexpr double kQuadrature = 1e-12;
  EXPECT_NEAR(inertia.mass_kg, 0.8589932413749422, kQuadrature);
  EXPECT_NEAR(inertia.cm_m, 0.500671268854254, kQuadrature);
  EXPECT_NEAR(inertia.inertia_kgm2, 0.053773820942168996, kQuadrature);
}

// The error of a frequency falls with the fourth power of the element length, with constant and tapering elements.
TEST(BeamStructure, ConvergesWithTheFourthPowerOfTheElements) {
  const auto fourth_Hz = [](double elements) {
    return bat_modes(hollow_bat(BeamSupport::free), {.modes = 4, .max_element_fraction = 1 / elements}).freq_Hz[3];
  };
  const double exact_Hz = fourth_Hz(400);
  // 6, 1, 5, 5 elements in the stretches of 0.3, 0.05, 0.25, 0.24 m, and twice as many.
  const double coarse = fourth_Hz(0.84 / 0.05) - exact_Hz, fine = fourth_Hz(0.84 / 0.025) - exact_Hz;
  EXPECT_GT(coarse / fine, 12);
  EXPECT_LT(coarse / fine, 20);
}

TEST(BeamStructure, TakesTheDensityFromTheMass) {
  BeamStructure bat = hollow_bat(BeamSupport::free);
  bat.material.density_kgpm3 = density_for_mass(bat, 0.9);
  EXPECT_NEAR(inertia_of(timoshenko_beam(bat, 0.01)).mass_kg, 0.9, 1e-14);
  EXPECT_THROW(density_for_mass(bat, 0.08), InputError);  // the added masses weigh as much
  for (SectionStation& station : bat.table.stations) station.layers[0].density_kgpm3 = 2700;
  EXPECT_THROW(density_for_mass(bat, 0.9), InputError);
}

}  // namespace percuss::model::beam_structure_test
