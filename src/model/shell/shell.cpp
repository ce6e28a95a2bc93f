#include "model/shell/shell.hpp"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "core/units.hpp"

namespace percuss::model {
namespace {

// n²(n² − 1)²/(n² + 1)
double pattern_factor(std::size_t n) {
  const auto square = static_cast<double>(n * n);
  return square * (square - 1) * (square - 1) / (square + 1);
}

// ω of Ω = 1: √(E/(ρ(1 − ν²)))/R.
double unit_radps(const TubeShell& s) {
  return std::sqrt(s.young_Pa / (s.density_kgpm3 * (1 - s.poisson * s.poisson))) / s.radius_m();
}

double wall_parameter(const TubeShell& s) { return s.wall_m * s.wall_m / (12 * s.radius_m() * s.radius_m()); }

}  // namespace

double ring_Hz(const TubeShell& s, std::size_t n) {
  return rayleigh_Hz(s, n) * std::sqrt(1 - s.poisson * s.poisson);  // (1)
}

double rayleigh_Hz(const TubeShell& s, std::size_t n) {
  return unit_radps(s) * std::sqrt(wall_parameter(s) * pattern_factor(n)) / kTwoPi;  // (2)
}

double love_Hz(const TubeShell& s, std::size_t n) {
  const double slender = std::pow(s.radius_m() / s.length_m, 2), square = static_cast<double>(n * n);
  return rayleigh_Hz(s, n) * std::sqrt((1 + 24 * (1 - s.poisson) * slender / square) /
                                       (1 + 12 * slender / (square * (square + 1))));  // (3)
}

double flugge_Hz(const TubeShell& s, std::size_t waves, std::size_t half_waves) {
  const double n = static_cast<double>(waves), k = wall_parameter(s), nu = s.poisson;
  const double l = static_cast<double>(half_waves) * std::numbers::pi * s.radius_m() / s.length_m, l2 = l * l,
               n2 = n * n;
  Eigen::Matrix3d matrix;                                                         // (4); only its lower half is read
  matrix << l2 + (1 - nu) / 2 * n2 * (1 + k), 0, 0,                               //
      -(1 + nu) / 2 * n * l, n2 + (1 - nu) / 2 * l2 * (1 + 3 * k), 0,             //
      -nu * l - k * l * (l2 - (1 - nu) / 2 * n2), n + k * (3 - nu) / 2 * l2 * n,  //
      1 + k * (std::pow(l2 + n2, 2) - 2 * n2 + 1);
  // The three eigenvalues lie far apart. Computed as the largest of the inverse, the lowest stays accurate for thin
  // walls.
  const double lowest =
      1 / Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(
              Eigen::Matrix3d(matrix.selfadjointView<Eigen::Lower>()).inverse(), Eigen::EigenvaluesOnly)
              .eigenvalues()[2];
  return unit_radps(s) * std::sqrt(lowest) / kTwoPi;
}

double tube_mass_kg(const TubeShell& s) {
  return s.density_kgpm3 * std::numbers::pi * (s.outer_diameter_m - s.wall_m) * s.wall_m * s.length_m;
}

}  // namespace percuss::model
