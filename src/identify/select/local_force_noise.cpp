#include "identify/select/local_force_noise.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math/linear_algebra.hpp"
#include "core/math/tall_products.hpp"
#include "identify/noise/force_noise.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

constexpr double kMinRelativeNoise = 1e-6;  // of the largest noise: limits the weight of a noise-free FRF

using WindowModes = std::vector<FittedMode*>;  // modes that were fitted together

bool is_local_fit(const FittedMode& mode) { return !mode.joint && !(mode.mode.freq_scatter_Hz > 0); }

// Derivatives of a window's FRFs by the poles, the linear part (modes and polynomial) projected out.
struct Slopes {
  MatrixXcd lines;  // [lines, 2 modes] by frequency and damping ratio
  MatrixXcd gram;
};

Slopes slopes_of(const FrfDataset& set, std::size_t point, const WindowModes& modes) {
  const auto lines = static_cast<Index>(modes.front()->count);
  const auto count = static_cast<Index>(modes.size());
  MatrixXcd columns(lines, count);
  Slopes slopes{.lines = MatrixXcd(lines, 2 * count), .gram = {}};
  for (Index m = 0; m < count; ++m) {
    const FittedMode& mode = *modes[static_cast<std::size_t>(m)];
    const ModeColumn column = mode_column(mode.mode.pole, set.points[point], set.lines, mode.first, mode.count);
    columns.col(m) = column.value;
    slopes.lines.col(2 * m) = column.by_freq;
    slopes.lines.col(2 * m + 1) = column.by_damping;
  }
  const MatrixXd polynomial = orthonormal_polynomials(lines, static_cast<Index>(LocalFitOptions{}.residual_terms));
  for (MatrixXcd* const of : {&columns, &slopes.lines})
    subtract_product(*of, polynomial, transposed_product(polynomial, *of));
  const MatrixXcd projection = inverse_gram(adjoint_gram(columns)) * adjoint_product(columns, slopes.lines);
  subtract_product(slopes.lines, columns, projection);
  slopes.gram = adjoint_gram(slopes.lines);
  return slopes;
}

// Fisher information of the poles, and the covariance of the score from the errors of the gain.
struct PoleInformation {
  MatrixXd fisher, force;
};

void add_point(const FrfDataset& set, std::size_t point, const WindowModes& modes, const Slopes& slopes,
               PoleInformation& sum) {
  const std::size_t first = modes.front()->first;
  const auto lines = static_cast<Index>(modes.front()->count);
  const Index n = slopes.lines.cols();
  const double least = kMinRelativeNoise * modes.front()->noise.maxCoeff();
  MatrixXcd score = MatrixXcd::Zero(lines, n);  // effect of a gain error at each line
  for (std::size_t o = 0; o < set.channels.size(); ++o) {
    if (set.channels[o].point != point) continue;
    const double weight = 1 / std::pow(std::max(modes.front()->noise(static_cast<Index>(o)), least), 2);
    const Eigen::Map<const Eigen::VectorXcd> frf(set.channels[o].frf.data() + first, lines);
    const auto residue = [&](Index r) { return modes[static_cast<std::size_t>(r / 2)]->mode.residues[o].value; };
    for (Index r = 0; r < n; ++r) {
      const Complex weighted_residue = std::conj(residue(r)) * weight;
      score.col(r) += weighted_residue * slopes.lines.col(r).conjugate().cwiseProduct(frf);
      for (Index c = 0; c < n; ++c) sum.fisher(r, c) += (weighted_residue * slopes.gram(r, c) * residue(c)).real();
    }
  }
  std::vector<std::size_t> window(modes.front()->count);
  std::iota(window.begin(), window.end(), first);
  const MatrixXcd errors = gain_errors(set, point, window);
  if (errors.size() == 0) return;
  const MatrixXd force_score = (score.transpose() * errors).real();
  sum.force += force_score * force_score.transpose();
}

void add_force_noise_to_window(const FrfDataset& set, const WindowModes& modes) {
  const auto n = static_cast<Index>(2 * modes.size());
  PoleInformation sum{.fisher = MatrixXd::Zero(n, n), .force = MatrixXd::Zero(n, n)};
  const bool decayed = std::all_of(modes.begin(), modes.end(), [&](const FittedMode* mode) {
    return decays_within_record(mode->mode.pole, set.points.front(), set.lines);
  });
  Slopes slopes;
  for (std::size_t point = 0; point < set.points.size(); ++point) {
    if (point == 0 || !decayed) slopes = slopes_of(set, point, modes);
    add_point(set, point, modes, slopes, sum);
  }
  const MatrixXd inverse = inverse_gram(sum.fisher);
  const MatrixXd added = inverse * sum.force * inverse;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (!is_local_fit(*modes[m])) continue;
    const auto i = static_cast<Index>(2 * m);
    Mode& mode = modes[m]->mode;
    mode.freq_std_Hz = std::hypot(mode.freq_std_Hz, std::sqrt(std::max(0.0, added(i, i))));
    mode.damping_std = std::hypot(mode.damping_std, std::sqrt(std::max(0.0, added(i + 1, i + 1))));
  }
}

}  // namespace

void add_force_noise(const FrfDataset& set, std::vector<FittedMode>& modes) {
  std::vector<char> done(modes.size(), 0);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (done[m] || !is_local_fit(modes[m])) continue;
    WindowModes together;
    for (std::size_t i = 0; i < modes.size(); ++i) {
      if (modes[i].first != modes[m].first || modes[i].count != modes[m].count) continue;
      together.push_back(&modes[i]);
      done[i] = 1;
    }
    add_force_noise_to_window(set, together);
  }
}

}  // namespace percuss::identify
