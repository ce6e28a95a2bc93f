#include "model/bat/bat_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace percuss::model::bat_modes_test {

// A bat of four slices. Reference: exact solutions of Timoshenko's equations slice by slice (scipy's expm of the 4 x 4
// system, multiplied along the bat; brentq on the determinant of the free ends), computed without percuss.
const BatProfile kStepped{.end_m = {0.02, 0.40, 0.50, 0.82}, .diameter_m = {0.050, 0.026, 0.040, 0.062}};
const std::vector<double> kStepped_Hz{161.04226133793202, 601.7006230909085,  1255.9322372200618,
                                      1874.1156656574703, 2604.3511337161294, 3329.3845613807975};
// With 84 elements or a few more, the error is 2e-6 at the sixth mode and 5e-6 at the seventh (fourth order).
constexpr double kElements = 1e-5;

BatProfile rod(double length_m, double diameter_m) { return {.end_m = {length_m}, .diameter_m = {diameter_m}}; }

TEST(BatModes, ReproducesTheExactFrequencies) {
  const BatModes modes = bat_modes(kStepped, {});
  for (Eigen::Index i = 0; i < std::ssize(kStepped_Hz); ++i) {
    const double exact_Hz = kStepped_Hz[static_cast<std::size_t>(i)];
    EXPECT_NEAR(modes.freq_Hz[i], exact_Hz, kElements * exact_Hz) << i;
  }
}

TEST(BatModes, ReproducesTheExactNodes) {
  const BatModes modes = bat_modes(kStepped, {});
  const std::vector<std::vector<double>> exact_m{{0.174654627, 0.649983862},
                                                 {0.065089854, 0.372781817, 0.688014908},
                                                 {0.041686611, 0.225281218, 0.478520169, 0.717884136}};
  constexpr double kPlace_m = 1e-6;  // three times the error of the elements at the nodes of the third mode
  for (std::size_t mode = 0; mode < exact_m.size(); ++mode) {
    const auto found_m = nodes_of(modes, mode);
    ASSERT_EQ(found_m.size(), exact_m[mode].size());
    for (std::size_t i = 0; i < found_m.size(); ++i) EXPECT_NEAR(found_m[i], exact_m[mode][i], kPlace_m);
  }
}

TEST(BatModes, HaveNodesWhereTheDeflectionIsZero) {
  const BatModes modes = bat_modes(kStepped, {});
  constexpr double kRounding = 1e-13;  // of the deflection at the tip: six shape functions at a rounded position
  for (std::size_t mode = 0; mode < 10; ++mode) {
    const auto column = static_cast<Eigen::Index>(mode);
    const double tip = std::abs(modes.deflection(modes.length_m)[column]);
    for (const double node_m : nodes_of(modes, mode))
      EXPECT_LE(std::abs(modes.deflection(node_m)[column]), kRounding * tip) << mode << " at " << node_m;
  }
}

TEST(BatModes, HaveTheMassOfTheSlices) {
  const BatInertia inertia = bat_modes(kStepped, {}).inertia;
  constexpr double kRounding = 1e-14;
  EXPECT_NEAR(inertia.mass_kg, 0.864980234515948, kRounding);
  EXPECT_NEAR(inertia.cm_m, 0.5529285310201772, kRounding);
  EXPECT_NEAR(inertia.inertia_kgm2, 0.03812615900067391, kRounding);
}

// The same reference for a rod of 40 mm: shear and rotary inertia lower the first mode by 2 %, the seventh by a third.
TEST(BatModes, MatchTimoshenkoForAUniformRod) {
  const BatModes modes = bat_modes(rod(0.84, 0.040), {});
  const std::vector<double> exact_Hz{262.00417315568757, 692.7111230780149,  1281.977688907523, 1978.4243100382364,
                                     2742.470595645941,  3545.5726138198615, 4369.083592510567};
  for (Eigen::Index i = 0; i < std::ssize(exact_Hz); ++i)
    EXPECT_NEAR(modes.freq_Hz[i], exact_Hz[static_cast<std::size_t>(i)], kElements * modes.freq_Hz[i]) << i;
}

// Thin elements do not lock: the Euler–Bernoulli frequencies are ω = λ²/L² √(EI/ρA) with cos λ cosh λ = 1. Rotary
// inertia and shear lower them by a relative (λ d/4L)² (1 + E/κG)/2 or less.
TEST(BatModes, MatchEulerBernoulliForAThinRod) {
  const BatMaterial material;
  const double diameter_m = 1e-3;
  const BatModes modes = bat_modes(rod(1, diameter_m), material);
  const std::vector<double> lambda{4.730040744862704, 7.853204624095838, 10.995607838001671, 14.137165491257464};
  const double wave = std::sqrt(material.young_Pa / material.density_kgpm3) * diameter_m / 4;
  for (std::size_t i = 0; i < lambda.size(); ++i) {
    const double euler_Hz = lambda[i] * lambda[i] * wave / (2 * std::numbers::pi);
    const double slight = std::pow(lambda[i] * diameter_m / 4, 2) * (1 + material.young_Pa / material.shear_Pa);
    EXPECT_NEAR(modes.freq_Hz[static_cast<Eigen::Index>(i)], euler_Hz, (slight + 1e-6) * euler_Hz) << i;
  }
}

TEST(BatModes, ConvergeWithTheFourthPowerOfTheElements) {
  const auto error = [](double elements) {
    const BatModes modes = bat_modes(kStepped, {}, {.modes = 6, .max_element_fraction = 1 / elements});
    return modes.freq_Hz[5] / kStepped_Hz[5] - 1;
  };
  const double coarse = error(41), fine = error(82);  // both cut the slices evenly
  EXPECT_GT(fine, 0);                                 // Ritz: from above
  EXPECT_NEAR(coarse / fine, 16, 2);
}

constexpr double kOrthogonal = 1e-12;

// The modes are orthogonal in the mass matrix with rotary inertia, and not without it. This settles a dispute in [10]
// of docs/theory/sources.md.
TEST(BatModes, AreOrthogonalInTheFullMassMatrix) {
  const BatModes modes = bat_modes(kStepped, {}, {.modes = 200});
  const Eigen::MatrixXd product = modes.shape.transpose() * (modes.beam.mass * modes.shape);
  EXPECT_LE((product - Eigen::MatrixXd::Identity(product.rows(), product.cols())).cwiseAbs().maxCoeff(), kOrthogonal);
  const TimoshenkoBeam beam = timoshenko_beam(kStepped, {}, modes.length_m / 84);
  Eigen::MatrixXd plain = Eigen::MatrixXd::Zero(6, 6);
  constexpr int kPoints = 2000;  // ρA w wᵀ, summed over the bat: no rotary inertia
  for (int i = 0; i < kPoints; ++i) {
    const double z_m = (i + 0.5) * modes.length_m / kPoints;
    const Eigen::VectorXd w = modes.deflection(z_m).head(6);
    plain += beam.elements[element_at(beam, z_m)].mass_kgpm * modes.length_m / kPoints * w * w.transpose();
  }
  plain.diagonal().setZero();
  EXPECT_GT(plain.cwiseAbs().maxCoeff(), 0.005);
}

TEST(BatModes, AreOrthogonalToTheRigidBodyModes) {
  const BatModes modes = bat_modes(kStepped, {});
  Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(modes.shape.rows(), 2);
  Eigen::Index row = 0;
  for (const double z_m : positions_of(modes.beam)) {
    rigid.row(row) << 1, z_m;
    rigid(row + 1, 1) = 1;
    row += kUnknownsPerElement;
  }
  EXPECT_LE((rigid.transpose() * (modes.beam.mass * modes.shape)).cwiseAbs().maxCoeff(), kOrthogonal);
  EXPECT_LE((modes.beam.stiffness * rigid).cwiseAbs().maxCoeff(), 1e-6 * modes.beam.stiffness.coeffs().maxCoeff());
}

// The residual K q − ω² M q of each mode.
TEST(BatModes, SolveTheEigenvalueProblem) {
  const BatModes modes = bat_modes(kStepped, {}, {.modes = 60});
  for (Eigen::Index i = 0; i < modes.freq_Hz.size(); ++i) {
    const double square = std::pow(2 * std::numbers::pi * modes.freq_Hz[i], 2);
    const Eigen::VectorXd inertia = square * (modes.beam.mass * modes.shape.col(i));
    EXPECT_LE((modes.beam.stiffness * modes.shape.col(i) - inertia).norm(), 1e-6 * inertia.norm()) << i;
  }
}

TEST(BatModes, AreLimitedByTheElements) {
  const BatModes modes = bat_modes(rod(0.84, 0.04), {}, {.modes = 200, .max_element_fraction = 0.25});
  EXPECT_EQ(modes.freq_Hz.size(), 16);  // four elements: 18 unknowns, two of them rigid
}

}  // namespace percuss::model::bat_modes_test
