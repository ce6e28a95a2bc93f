#include "identify/misfit/misfit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "core/math/linear_algebra.hpp"
#include "core/math/significance.hpp"
#include "core/math/tall_products.hpp"
#include "core/parallel/parallel.hpp"
#include "identify/fit/local_fit.hpp"
#include "identify/fit/variable_projection.hpp"
#include "identify/misfit/decay_terms.hpp"
#include "identify/misfit/point_scatter.hpp"
#include "identify/misfit/residual_correlation.hpp"
#include "identify/noise/line_noise.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr double kMinIndependent = 0.5;  // of the independent lines: at least this part remains after the fit
constexpr double kMinNoise = 1e-300;
constexpr std::size_t kFlopsPerLine = 600;

VectorXd noise_of(const ProjectedState& state, Index channels, double freedom) {
  VectorXd noise(channels);
  for (const ProjectedPart& part : state.parts) {
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      noise(static_cast<Index>(part.channels[i])) =
          std::max(kMinNoise, std::sqrt(part.residual.col(static_cast<Index>(i)).squaredNorm() / freedom));
    }
  }
  return noise;
}

// Σ over the FRFs of the products of their residues over their noise, [2 modes, 2 modes].
MatrixXcd residue_products(const ProjectedPart& part, const VectorXd& noise) {
  const Index n = part.slopes.cols();
  MatrixXcd sum = MatrixXcd::Zero(n, n);
  for (std::size_t i = 0; i < part.channels.size(); ++i) {
    const double w = noise(static_cast<Index>(part.channels[i]));
    for (Index r = 0; r < n; ++r) {
      for (Index c = 0; c < n; ++c) {
        sum(r, c) += std::conj(part.amplitude(r / 2, static_cast<Index>(i))) *
                     part.amplitude(c / 2, static_cast<Index>(i)) / (w * w);
      }
    }
  }
  return sum;
}

// Covariance of the score for a residual with this correlation. The residual's real and imaginary part have half its
// variance each.
MatrixXd score_covariance(const VariableProjection& projection, const ProjectedState& state, const VectorXd& noise,
                          const ResidualCorrelation& correlation) {
  const Index n = state.parts.front().slopes.cols();
  MatrixXd sum = MatrixXd::Zero(n, n);
  for (const ProjectedPart& part : state.parts) {
    const MatrixXcd slopes = projection.projected_slopes(part);
    const MatrixXcd residues = residue_products(part, noise);
    sum += 0.5 * residues.cwiseProduct(lagged_product(slopes, slopes, 0)).real();
    for (std::size_t l = 0; l < correlation.at_lag.size(); ++l) {
      const MatrixXcd lagged = lagged_product(slopes, slopes, static_cast<Index>(l + 1));
      const MatrixXd one = residues.cwiseProduct(lagged).real();
      sum += 0.5 * correlation.at_lag[l] * (one + one.transpose());
    }
  }
  return sum;
}

// Energy of the sum of all FRFs' scores over the sum of the scores' energies: 1 for independent residuals, the number
// of FRFs for the same misfit in all.
double common_to_channels(const VariableProjection& projection, const ProjectedState& state, const VectorXd& noise) {
  double together = 0, apart = 0;
  for (Index m = 0; m < state.parts.front().columns.cols(); ++m) {
    VectorXd sum;
    for (const ProjectedPart& part : state.parts) {
      const MatrixXcd slopes = projection.projected_slopes(part);
      for (std::size_t i = 0; i < part.channels.size(); ++i) {
        const auto column = static_cast<Index>(i);
        const double w = noise(static_cast<Index>(part.channels[i]));
        const Complex residue = std::conj(part.amplitude(m, column)) / (w * w);
        const VectorXd score = (residue * slopes.col(2 * m).conjugate().cwiseProduct(part.residual.col(column))).real();
        sum = sum.size() == 0 ? score : VectorXd(sum + score);
        apart += score.squaredNorm();
      }
    }
    together += sum.squaredNorm();
  }
  return apart > 0 ? std::max(1.0, together / apart) : 1;
}

// [2 modes] standard deviations for the residual's covariance; 0 if the residual is as white as noise.
VectorXd smooth_misfit_std(const VariableProjection& projection, const ProjectedState& state, const VectorXd& noise,
                           double used) {
  const Index n = state.parts.front().slopes.cols();
  const Index lines = state.parts.front().residual.rows();
  const MatrixXd polynomial = orthonormal_polynomials(lines, static_cast<Index>(LocalFitOptions{}.residual_terms));
  const ResidualCorrelation correlation = residual_correlation(state, polynomial, noise);
  if (!(correlation.deviate > kOnceIn300000)) return VectorXd::Zero(n);
  const MatrixXd inverse = inverse_gram(projection.normal_equations(state, static_cast<std::size_t>(n / 2)).matrix);
  const MatrixXd covariance = inverse * score_covariance(projection, state, noise, correlation) * inverse;
  // The fit follows a part of a smooth misfit. This part grows as fewer lines are independent.
  const double independent = static_cast<double>(lines) / correlation.lines;
  const double freedom_correction = independent / std::max(independent - used, kMinIndependent * independent);
  const double factor = freedom_correction * common_to_channels(projection, state, noise);
  return (factor * covariance.diagonal()).cwiseMax(0.0).cwiseSqrt();
}

void widen(double misfit, StdParts& parts, double& std) {
  if (!(misfit > parts.noise)) return;
  parts.misfit = std::sqrt(misfit * misfit - parts.noise * parts.noise);
  std = parts.total();
}

// `line_noise`: for the scatter of the sensors of few points.
void add_misfit_of_window(const FrfDataset& set, const std::optional<LineNoise>& line_noise, const ModeWindow& window,
                          std::vector<Mode>& modes) {
  const std::vector<Pole> poles = window.poles(modes);
  const auto data = window_data(set, modes, window);
  const auto terms = static_cast<Index>(LocalFitOptions{}.residual_terms);
  VariableProjection projection(set, data, VectorXd::Ones(static_cast<Index>(data.size())), window.first, window.count,
                                static_cast<std::size_t>(terms));
  const ProjectedState state = projection.evaluate(poles);
  const double used = static_cast<double>(poles.size()) + static_cast<double>(terms);
  const auto lines = static_cast<double>(window.count);
  if (!(lines > 2 * used)) return;
  const VectorXd noise = noise_of(state, static_cast<Index>(data.size()), lines - used);
  projection.set_noise_scale(noise);
  const VectorXd shift = decay_term_shift(set, window, poles, projection, state, noise);
  const VectorXd smooth = smooth_misfit_std(projection, state, noise, used);
  VectorXd misfit = smooth.cwiseMax(shift);
  if (set.points.size() >= kMinScatterPoints) {
    misfit = misfit.cwiseMax(point_scatter_std(projection, state, poles.size()));
  } else if (line_noise) {
    projection.set_noise_scale(line_noise->over(window.first, window.count));
    misfit = misfit.cwiseMax(sensor_scatter_std(projection, state, poles.size()));
  }
  for (std::size_t i = 0; i < poles.size(); ++i) {
    const auto f = static_cast<Index>(2 * i);
    Mode& mode = modes[window.modes[i]];
    widen(misfit(f), mode.freq_std_parts_Hz, mode.freq_std_Hz);
    widen(misfit(f + 1), mode.damping_std_parts, mode.damping_std);
  }
}

void add_misfit_inside(const FrfDataset& set, std::vector<Mode>& modes) {
  if (modes.empty()) return;
  const std::vector<ModeWindow> windows = mode_windows(set, modes);
  std::optional<LineNoise> line_noise;
  if (set.points.size() < kMinScatterPoints && set.channels.size() > 1) line_noise.emplace(set);
  parallel_for_cost(windows.size(), kFlopsPerLine * windows.front().count * set.channels.size(), [&](std::size_t w) {
    const bool scatters = std::any_of(windows[w].modes.begin(), windows[w].modes.end(),
                                      [&](std::size_t m) { return modes[m].freq_scatter_Hz > 0; });
    if (!scatters) add_misfit_of_window(set, line_noise, windows[w], modes);
  });
}

}  // namespace

// A mode that left the lines in the last joint fit may have a large residue: with the residual terms, it describes the
// flank of modes beyond the lines. This sum is smooth, but neither part alone is. The polynomial of each window follows
// the sum, so that the mode is not subtracted.
void add_misfit(const FrfDataset& set, std::vector<Mode>& modes) {
  // An exponential window correlates the noise itself.
  if (modes.empty() || set.window_decay_per_s() != 0) return;
  const double low_Hz = set.lines.freq_Hz(0), high_Hz = set.lines.freq_Hz(set.lines.count - 1);
  const auto lies_inside = [&](const Mode& mode) {
    return mode.pole.freq_Hz >= low_Hz && mode.pole.freq_Hz <= high_Hz;
  };
  if (std::all_of(modes.begin(), modes.end(), lies_inside)) {
    add_misfit_inside(set, modes);
    return;
  }
  std::vector<Mode> inside;
  std::copy_if(modes.begin(), modes.end(), std::back_inserter(inside), lies_inside);
  add_misfit_inside(set, inside);
  auto next = inside.begin();
  for (Mode& mode : modes) {
    if (lies_inside(mode)) mode = std::move(*next++);
  }
}

std::vector<Mode> with_misfit(const FrfDataset& set, std::vector<Mode> modes) {
  for (Mode& mode : modes) {
    mode.freq_std_parts_Hz.noise = mode.freq_std_Hz;
    mode.damping_std_parts.noise = mode.damping_std;
  }
  add_misfit(set, modes);
  return modes;
}

}  // namespace percuss::identify
