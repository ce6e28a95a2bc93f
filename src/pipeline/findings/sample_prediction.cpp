#include "pipeline/findings/sample_prediction.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"

namespace percuss::pipeline {
namespace {

using Eigen::Index;
using Eigen::Map;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr auto kOrder = static_cast<Index>(kPredictionOrder);
constexpr std::size_t kMinEquations = 4 * kPredictionOrder;
constexpr Index kBlockRows = 200;
constexpr std::size_t kStdSamples = 300;  // on either side: errors follow the size of the motion

Map<const VectorXd> ahead(std::span<const double> x, std::size_t n) { return {x.data() + n + 1, kOrder}; }
auto behind(std::span<const double> x, std::size_t n) {
  return Map<const VectorXd>(x.data() + n - kPredictionOrder, kOrder).reverse();
}

// The samples whose prediction uses no sample nearer to `at` than `gap`.
struct Equations {
  std::vector<std::size_t> forward, backward;
};
Equations equations_around(std::size_t first, std::size_t end, std::size_t at, std::size_t gap) {
  Equations out;
  const std::size_t low = at > gap ? at - gap : 0, high = at + gap;
  for (std::size_t n = first; n < end; ++n) {
    const bool before = n<low, after = n> high;
    if (n >= first + kPredictionOrder && (before || n > high + kPredictionOrder)) out.forward.push_back(n);
    if (n + kPredictionOrder < end && (after || n + kPredictionOrder < low)) out.backward.push_back(n);
  }
  return out;
}

double robust_error(const std::vector<std::size_t>& at, std::size_t middle, const auto& error) {
  std::vector<double> errors;
  for (const std::size_t n : at) {
    if ((n > middle ? n - middle : middle - n) < kStdSamples) errors.push_back(error(n));
  }
  return robust_std(std::move(errors));
}

// The least-squares solution by the QR decompositions of blocks of rows that stay in the processor's cache.
VectorXd solve_by_blocks(const MatrixXd& left, const VectorXd& right) {
  const Index columns = left.cols() + 1;
  MatrixXd triangle = MatrixXd::Zero(columns, columns);
  for (Index row = 0; row < left.rows(); row += kBlockRows) {
    const Index count = std::min(kBlockRows, left.rows() - row);
    MatrixXd block(columns + count, columns);
    block.topRows(columns) = triangle;
    block.bottomLeftCorner(count, left.cols()) = left.middleRows(row, count);
    block.bottomRightCorner(count, 1) = right.segment(row, count);
    triangle = Eigen::HouseholderQR<MatrixXd>(block).matrixQR().topRows(columns).triangularView<Eigen::Upper>();
  }
  const Index n = left.cols();
  return triangle.topLeftCorner(n, n).triangularView<Eigen::Upper>().solve(triangle.col(n).head(n));
}

VectorXd weights(std::span<const std::span<const double>> channels, const std::vector<double>& scale,
                 const std::vector<std::size_t>& at, bool forward) {
  const auto rows = static_cast<Index>(at.size() * channels.size());
  MatrixXd left(rows, kOrder);
  VectorXd right(rows);
  Index row = 0;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    for (const std::size_t n : at) {
      if (forward) {
        left.row(row) = behind(channels[c], n).transpose() * scale[c];
      } else {
        left.row(row) = ahead(channels[c], n).transpose() * scale[c];
      }
      right[row++] = channels[c][n] * scale[c];
    }
  }
  return solve_by_blocks(left, right);
}

}  // namespace

double forward_error(const SamplePrediction& prediction, std::span<const double> x, std::size_t n) {
  return x[n] - prediction.forward.dot(behind(x, n));
}

double backward_error(const SamplePrediction& prediction, std::span<const double> x, std::size_t n) {
  return x[n] - prediction.backward.dot(ahead(x, n));
}

bool can_fit_prediction(std::size_t first, std::size_t end, std::size_t at, std::size_t gap) {
  const Equations equations = equations_around(first, end, at, gap);
  return std::min(equations.forward.size(), equations.backward.size()) >= kMinEquations;
}

std::optional<SamplePrediction> fit_prediction(std::span<const std::span<const double>> channels, std::size_t first,
                                               std::size_t end, std::size_t at, std::size_t gap) {
  const Equations equations = equations_around(first, end, at, gap);
  if (std::min(equations.forward.size(), equations.backward.size()) < kMinEquations) return std::nullopt;
  std::vector<double> scale;
  for (const auto x : channels) {
    const double level = rms(x.subspan(first, end - first));
    scale.push_back(level > 0 ? 1 / level : 0);
  }
  SamplePrediction out{.forward = weights(channels, scale, equations.forward, true),
                       .backward = weights(channels, scale, equations.backward, false),
                       .forward_std = {},
                       .backward_std = {}};
  for (const auto x : channels) {
    out.forward_std.push_back(
        robust_error(equations.forward, at, [&](std::size_t n) { return forward_error(out, x, n); }));
    out.backward_std.push_back(
        robust_error(equations.backward, at, [&](std::size_t n) { return backward_error(out, x, n); }));
  }
  return out;
}

Interpolation interpolate_samples(const SamplePrediction& prediction, std::size_t channel, std::span<const double> x,
                                  std::size_t before, std::size_t count) {
  std::vector<double> known(x.begin(), x.end());
  std::fill_n(known.begin() + static_cast<std::ptrdiff_t>(before), count, 0.0);
  const std::size_t from = before, to = before + count;
  // The errors that depend on an unknown sample, as far as x holds all samples of their predictions.
  const std::size_t forward_first = std::max(from, kPredictionOrder);
  const std::size_t forward_end = std::max(forward_first, std::min(to + kPredictionOrder, x.size()));
  const std::size_t backward_first = from - std::min(from, kPredictionOrder);
  const std::size_t backward_end =
      std::max(backward_first, std::min(to, x.size() - std::min(x.size(), kPredictionOrder)));
  const auto rows = static_cast<Index>(forward_end - forward_first + backward_end - backward_first);
  MatrixXd left = MatrixXd::Zero(rows, static_cast<Index>(count));
  VectorXd right(rows);
  const double forward_weight = 1 / prediction.forward_std[channel];
  const double backward_weight = 1 / prediction.backward_std[channel];
  Index row = 0;
  for (std::size_t n = forward_first; n < forward_end; ++n, ++row) {
    right[row] = -forward_weight * forward_error(prediction, known, n);
    for (std::size_t u = from; u < to && u <= n; ++u) {
      const std::size_t lag = n - u;
      if (lag > kPredictionOrder) continue;
      left(row, static_cast<Index>(u - from)) =
          forward_weight * (lag == 0 ? 1 : -prediction.forward[static_cast<Index>(lag - 1)]);
    }
  }
  for (std::size_t n = backward_first; n < backward_end; ++n, ++row) {
    right[row] = -backward_weight * backward_error(prediction, known, n);
    for (std::size_t u = std::max(from, n); u < to; ++u) {
      const std::size_t lag = u - n;
      if (lag > kPredictionOrder) continue;
      left(row, static_cast<Index>(u - from)) =
          backward_weight * (lag == 0 ? 1 : -prediction.backward[static_cast<Index>(lag - 1)]);
    }
  }
  Interpolation out{.samples = left.householderQr().solve(right)};
  out.square = (left * out.samples - right).squaredNorm();
  out.freedom = static_cast<std::size_t>(rows) - count;
  return out;
}

}  // namespace percuss::pipeline
