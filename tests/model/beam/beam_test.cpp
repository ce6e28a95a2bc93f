#include "model/beam/beam.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"

namespace percuss::model::beam_test {

constexpr double kRounding = 1e-12;  // relative, of some dozens of operations
const std::vector<BeamSupport> kAll{BeamSupport::torsion, BeamSupport::pinned, BeamSupport::clamped, BeamSupport::free};

UniformBeam held(BeamSupport support) { return {.support = support}; }
UniformBeam sprung(double relative) { return {.torsion_Nmprad = relative * 4000 / 0.57}; }

TEST(Beam, ReproducesTheCompositeBatOfKnowles) {
  const auto modes = beam_modes({}, 3);
  // The defaults, [9] in docs/theory/sources.md. Independent values; the tolerance is half of their last digit.
  EXPECT_NEAR(modes[0].freq_Hz(), 14.536, 0.5e-3);
  EXPECT_NEAR(modes[1].freq_Hz(), 322.433, 0.5e-3);
  EXPECT_NEAR(modes[2].freq_Hz(), 1037.79, 0.5e-2);
}

// Roots by scipy.optimize.brentq: cos x + 1/cosh x (clamped), cos x − 1/cosh x (free) and tan x − tanh x (pinned).
TEST(Beam, HasTheRootsOfClampedFreeAndPinnedBeams) {
  const auto lambda = [](BeamSupport support, std::size_t mode) {
    return beam_modes(held(support), mode + 1)[mode].lambda;
  };
  EXPECT_NEAR(lambda(BeamSupport::clamped, 0), 1.8751040687119611, kRounding);
  EXPECT_NEAR(lambda(BeamSupport::clamped, 2), 7.854757438237613, 10 * kRounding);
  EXPECT_NEAR(lambda(BeamSupport::pinned, 1), 3.9266023120479188, 10 * kRounding);
  EXPECT_NEAR(lambda(BeamSupport::free, 2), 4.730040744862704, 10 * kRounding);
  EXPECT_NEAR(lambda(BeamSupport::free, 3), 7.853204624095838, 10 * kRounding);
}

// The equation as published, where its terms do not overflow.
TEST(Beam, SolvesItsCharacteristicEquation) {
  for (const double relative : {1e-6, 1e-3, 0.171, 1.0, 30.0, 1e6}) {
    for (const BeamMode& mode : beam_modes(sprung(relative), 6)) {
      const double x = mode.lambda, c = std::cos(x), s = std::sin(x), ch = std::cosh(x), sh = std::sinh(x);
      const double terms = (relative + x) * ch;  // bound of the terms, because λ itself is rounded
      EXPECT_NEAR(relative * (1 + c * ch) - x * (s * ch - c * sh), 0, kRounding * terms) << relative;
    }
  }
}

TEST(Beam, RootsInterlaceForEverySpring) {
  constexpr std::size_t kModes = 60;
  const auto clamped = beam_modes(held(BeamSupport::clamped), kModes);
  const auto pinned = beam_modes(held(BeamSupport::pinned), kModes);
  std::vector<BeamMode> softer = pinned;
  for (int exponent = -6; exponent <= 6; ++exponent) {
    const auto modes = beam_modes(sprung(std::pow(10, exponent)), kModes);
    for (std::size_t i = 0; i < kModes; ++i) {
      EXPECT_GT(modes[i].lambda, softer[i].lambda) << exponent << ' ' << i;
      EXPECT_LT(modes[i].lambda, clamped[i].lambda) << exponent << ' ' << i;
    }
    softer = modes;
  }
}

TEST(Beam, BecomesPinnedOrClampedAtTheLimitsOfStiffness) {
  EXPECT_EQ(beam_modes(sprung(0), 4)[3].lambda, beam_modes(held(BeamSupport::pinned), 4)[3].lambda);
  EXPECT_EQ(beam_modes({.torsion_Nmprad = std::numeric_limits<double>::infinity()}, 4)[3].lambda,
            beam_modes(held(BeamSupport::clamped), 4)[3].lambda);
  // A soft spring turns the rigid beam: ω² = T/(ρA L³/3), to first order in T* = T L/EI.
  constexpr double kSoft = 1e-6;  // T*; the next order is 0.12 of it
  const BeamMode soft = beam_modes(sprung(kSoft), 1)[0];
  const double rigid = std::sqrt(kSoft * 4000 / 0.57 / (2.24 * 0.57 * 0.57 * 0.57 / 3));
  EXPECT_NEAR(soft.omega_radps / rigid, 1, kSoft);
}

// Composite Simpson in many steps: its error falls as the fourth power of the step.
double integral(const UniformBeam& beam, const BeamMode& a, const BeamMode& b) {
  constexpr int kSteps = 20000;
  double sum = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double x_m = beam.length_m * i / kSteps;
    sum += (i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2) * a.shape(x_m) * b.shape(x_m);
  }
  return sum * beam.length_m / kSteps / 3;
}

TEST(Beam, HasOrthogonalShapesToModeFifty) {
  constexpr double kOrthogonal = 1e-12;  // rounding of 20 000 terms; measured 7e-15
  for (const BeamSupport support : kAll) {
    const UniformBeam beam = held(support);
    const auto modes = beam_modes(beam, 50);
    for (const std::size_t other : {0U, 1U, 7U, 30U, 48U}) {
      const double scale = std::sqrt(modes[49].norm_m * modes[other].norm_m);
      EXPECT_NEAR(integral(beam, modes[49], modes[other]) / scale, 0, kOrthogonal) << other;
    }
  }
}

TEST(Beam, HasTheIntegralOfItsSquaredShape) {
  constexpr double kSimpson = 1e-10;  // of the integration above, at mode 50; measured 4e-13
  for (const double relative : {1e-6, 0.171, 50.0}) {
    const UniformBeam beam = sprung(relative);
    const auto modes = beam_modes(beam, 50);
    for (const std::size_t i : {0U, 1U, 4U, 49U})
      EXPECT_NEAR(integral(beam, modes[i], modes[i]) / modes[i].norm_m, 1, kSimpson) << relative << ' ' << i;
  }
  for (const BeamSupport support : {BeamSupport::pinned, BeamSupport::clamped, BeamSupport::free}) {
    for (const BeamMode& mode : beam_modes(held(support), 5))
      EXPECT_NEAR(integral(held(support), mode, mode) / mode.norm_m, 1, kSimpson);
  }
}

TEST(Beam, MeetsTheBoundaryConditionsAtTheSupport) {
  for (const BeamMode& mode : beam_modes({}, 50)) {
    EXPECT_NEAR(mode.shape(0), 0, kRounding);
    EXPECT_NEAR(mode.shape(0.57), 1, kRounding);
    constexpr double d = 1e-6;
    constexpr double kDifferences = 1e-7;  // (d λ/L)²/6, 1e-8 at mode 50, and rounding over d, 1e-10
    EXPECT_NEAR((mode.shape(0.3 + d) - mode.shape(0.3 - d)) / (2 * d), mode.slope_1pm(0.3),
                kDifferences * mode.lambda / 0.57);
  }
  for (const BeamMode& mode : beam_modes(held(BeamSupport::clamped), 50))
    EXPECT_NEAR(mode.slope_1pm(0), 0, kRounding * mode.lambda / 0.57);
}

TEST(Beam, HasAsManyNodesAsItsNumber) {
  for (const BeamSupport support : kAll) {
    const auto modes = beam_modes(held(support), 50);
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const auto nodes = beam_nodes_m(modes[i]);
      EXPECT_EQ(nodes.size(), i) << static_cast<int>(support);
      EXPECT_TRUE(std::is_sorted(nodes.begin(), nodes.end()));
      for (const double node_m : nodes) EXPECT_NEAR(modes[i].shape(node_m), 0, kRounding);
    }
  }
}

TEST(Beam, HasTheTextbookNodesWhenFree) {
  // The first elastic mode of a free beam has a node at 0.224157 of the length; cos x cosh x = 1 solved by scipy.
  const auto nodes = beam_nodes_m(beam_modes(held(BeamSupport::free), 3)[2]);
  constexpr double kPrinted = 0.5e-10;
  EXPECT_NEAR(nodes[0] / 0.57, 0.2241575227, kPrinted);
  EXPECT_NEAR(nodes[0] + nodes[1], 0.57, kRounding);
}

TEST(Beam, ScalesWithItsDimensions) {
  const UniformBeam beam{.stiffness_Nm2 = 8000, .mass_per_length_kgpm = 1.12, .torsion_Nmprad = 2400, .length_m = 0.57};
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(beam_modes(beam, 5)[i].omega_radps / beam_modes({}, 5)[i].omega_radps, 2, kRounding);
}

// Reference: Ritz's method with Legendre polynomials to degree 24 for w and φ (scipy.linalg.eigh); EI 4000, ρA 2.24,
// L 0.57, T 1200, κGA 2e6 N, √(I/A) 0.05 m (a stubby beam, on which shear matters). The results of two
// polynomial degrees agree in all digits.
TEST(TimoshenkoBeam, AgreesWithRitz) {
  const std::vector<std::vector<double>> ritz_Hz{
      {14.360601, 285.5616003, 784.9535749, 1392.045375, 2049.497136, 2726.438275},
      {0, 282.948108, 782.6570269, 1390.243014, 2047.978267, 2725.311594},
      {70.57527564, 379.9899178, 906.1406458, 1506.34835, 2144.828568, 2771.074842},
      {0, 0, 386.1276095, 891.875386, 1488.906521, 2119.765205, 2766.066858}};
  constexpr double kPrinted_Hz = 5e-7;  // half of the last digit of most figures
  for (const BeamSupport support : kAll) {
    UniformBeam beam = held(support);
    beam.gyration_m = 0.05;
    beam.shear_stiffness_N = 2e6;
    const auto& expected = ritz_Hz.at(static_cast<std::size_t>(support));
    const auto modes = beam_modes(beam, expected.size());
    for (std::size_t i = 0; i < modes.size(); ++i) {
      EXPECT_NEAR(modes[i].freq_Hz(), expected[i], expected[i] > 0 ? kPrinted_Hz : 0)
          << static_cast<int>(support) << ' ' << i;
      EXPECT_EQ(beam_nodes_m(modes[i]).size(), i);
    }
    EXPECT_THROW(beam_modes(beam, expected.size() + 2), InputError);  // cut-off frequency 3007.7 Hz
  }
}

TEST(TimoshenkoBeam, BecomesAnEulerBernoulliBeamWhenSlender) {
  constexpr double kSlender = 1e-10;  // the relative effect of the gyration and of the shear on mode 12 is 2e-12
  for (const BeamSupport support : kAll) {
    UniformBeam beam = held(support);
    const auto euler = beam_modes(beam, 12);
    beam.gyration_m = 1e-8;
    beam.shear_stiffness_N = 1e19;
    const auto modes = beam_modes(beam, 12);
    for (std::size_t i = 0; i < modes.size(); ++i) {
      EXPECT_NEAR(modes[i].lambda, euler[i].lambda, kSlender);
      EXPECT_NEAR(modes[i].shape(0.2), euler[i].shape(0.2), kSlender) << i;
    }
  }
}

}  // namespace percuss::model::beam_test
