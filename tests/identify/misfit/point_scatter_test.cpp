#include "identify/misfit/point_scatter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/math/significance.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::point_scatter_test {

constexpr std::size_t kFirst = 150, kCount = 101, kTerms = 3;
constexpr double kNoise = 0.01;  // standard deviation of the real and of the imaginary part
constexpr Pole kPole{.freq_Hz = 350, .damping_ratio = 0.01};

enum class Frfs { of_a_point_each, of_one_point };

// FRFs whose pole has the frequency kPole.freq_Hz + off_Hz[FRF].
FrfDataset frfs_of(const std::vector<double>& off_Hz, const std::vector<double>& residue, std::uint64_t seed,
                   Frfs frfs) {
  FrfDataset set = test::empty_set(1000, 1000, 100, 490, off_Hz.size());
  for (std::size_t o = 0; o < off_Hz.size(); ++o) {
    if (frfs == Frfs::of_a_point_each) {
      if (o > 0) set.points.push_back(set.points.front());
      set.channels[o].point = o;
    }
    Pole pole = kPole;
    pole.freq_Hz += off_Hz[o];
    test::add_mode(set, o, pole, residue[o]);
  }
  test::add_frf_noise(set, kNoise, seed);
  return set;
}

// The scatter of these FRFs around a pole at kPole.freq_Hz + at_Hz.
Eigen::VectorXd scatter_of(const std::vector<double>& off_Hz, const std::vector<double>& residue, std::uint64_t seed,
                           Frfs frfs = Frfs::of_a_point_each, double at_Hz = 0) {
  const FrfDataset set = frfs_of(off_Hz, residue, seed, frfs);
  std::vector<Eigen::VectorXcd> data;
  for (const FrfChannel& channel : set.channels)
    data.emplace_back(Eigen::Map<const Eigen::VectorXcd>(channel.frf.data() + kFirst, kCount));
  const Eigen::VectorXd noise =
      Eigen::VectorXd::Constant(static_cast<Eigen::Index>(data.size()), std::sqrt(2.0) * kNoise);
  const VariableProjection projection(set, data, noise, kFirst, kCount, kTerms);
  Pole pole = kPole;
  pole.freq_Hz += at_Hz;
  const ProjectedState state = projection.evaluate({pole});
  return frfs == Frfs::of_one_point ? sensor_scatter_std(projection, state, 1)
                                    : point_scatter_std(projection, state, 1);
}

std::vector<double> equal(std::size_t points) {
  std::vector<double> ones(points, 1);
  return ones;
}

// The mean of n frequencies whose squared deviations have the sum S has the variance S/(n (n − 1)). The points have
// equal weights. The noise gives the frequency of a point a standard deviation of 1.4 mHz; the RMS of the deviations is
// 48 times as large. The pole update is linear in each deviation up to terms of (0.1 Hz/7 Hz)²; 7 Hz is the half-power
// bandwidth.
TEST(PointScatter, IsTheStandardDeviationOfTheMeanOfThePoints) {
  const std::vector<double> off_Hz{0.1, -0.1, 0.05, -0.05, 0.08, -0.08, 0.02, -0.02};
  double squares = 0;
  for (const double off : off_Hz) squares += off * off;
  const double expected = student_quantile(1.96, 7) / 1.96 * std::sqrt(squares / (8 * 7));
  EXPECT_NEAR(scatter_of(off_Hz, equal(8), 1)(0), expected, 0.02 * expected);
}

// The limit is 4.5 standard deviations, which noise exceeds in one of 300 000 unknowns.
TEST(PointScatter, IsZeroForNoise) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Eigen::VectorXd std = scatter_of(std::vector<double>(8, 0.0), equal(8), seed);
    EXPECT_EQ(std(0), 0) << seed;
    EXPECT_EQ(std(1), 0) << seed;
  }
}

TEST(PointScatter, NeedsThreePoints) {
  EXPECT_EQ(scatter_of({0.1, -0.1}, equal(2), 1)(0), 0);
  EXPECT_GT(scatter_of({0.1, -0.1, 0}, equal(3), 1)(0), 0);
}

// The least squares of two FRFs lie between their poles, which are d = 0.2 Hz apart: at the mean, weighted by the
// squares w of the residues. Each FRF contributes w₁ w₂ d/(w₁ + w₂)², and the standard deviation is the sum of both:
// d/2 for equal residues.
// The step of the pole is linear in the deviations up to terms of the relative size of 0.2 Hz over half of the
// half-power bandwidth, 3.5 Hz, which the tolerance allows. Noise is a twentieth of that.
constexpr double kNonlinear = 0.2 / 3.5;

TEST(SensorScatter, CoversWhatTwoSensorsShow) {
  EXPECT_NEAR(scatter_of({0.1, -0.1}, {1, 1}, 1, Frfs::of_one_point)(0), 0.1, kNonlinear * 0.1);
  const double mean_Hz = (1 * 0.1 + 4 * -0.1) / 5, expected = 2 * 4 / 25.0 * 0.2;
  EXPECT_NEAR(scatter_of({0.1, -0.1}, {1, 2}, 1, Frfs::of_one_point, mean_Hz)(0), expected, kNonlinear * expected);
}

// A fit that followed the first FRF alone is 0.1 Hz away from the least squares.
TEST(SensorScatter, CountsTheDistanceFromTheLeastSquares) {
  const double expected = std::hypot(0.1, 0.1);
  EXPECT_NEAR(scatter_of({0.1, -0.1}, {1, 1}, 1, Frfs::of_one_point, 0.1)(0), expected, kNonlinear * expected);
}

TEST(SensorScatter, IsZeroForNoise) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
    EXPECT_EQ(scatter_of({0, 0}, {1, 0.3}, seed, Frfs::of_one_point), Eigen::Vector2d::Zero()) << seed;
}

TEST(SensorScatter, NeedsTwoFrfs) { EXPECT_EQ(scatter_of({0.1}, {1}, 1, Frfs::of_one_point), Eigen::Vector2d::Zero()); }

// Two of eight points determine the pole. Their frequencies are 0.1 Hz above and below it, so their scatter has one
// degree of freedom; the factor is Student's for one. The other points have a hundredth of the residue. The variance is
// Σ (off/2)² = 0.02/4, with the weight 1/2 of each, times n/(n − 1) for all n = 8 points.
TEST(PointScatter, CountsThePointsThatDetermineThePole) {
  const std::vector<double> off_Hz{0.1, -0.1, 0, 0, 0, 0, 0, 0};
  const std::vector<double> residue{1, 1, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01};
  const double expected = student_quantile(1.96, 1) / 1.96 * std::sqrt(0.02 / 4 * 8 / 7);
  EXPECT_NEAR(scatter_of(off_Hz, residue, 1)(0), expected, 0.05 * expected);
}

}  // namespace percuss::identify::point_scatter_test
