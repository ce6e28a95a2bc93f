#include "identify/fit/principal_frfs.hpp"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "core/math/decompositions.hpp"
#include "core/parallel/parallel.hpp"
#include "identify/noise/line_noise.hpp"

namespace percuss {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kAboveNoise = 20;   // energy of a line, over the noise of all outputs, from which it tells directions
constexpr Index kColumns = 16;       // columns
constexpr std::size_t kCopied = 10;  // operations of a copied line
constexpr std::size_t kMostChosen = 1500;  // … the strongest ones

// The outputs over their noise, real parts above imaginary parts of the lines that stand out: [2 lines, outputs].
MatrixXd standing_out(const FrfSet& set, const VectorXd& noise) {
  const std::size_t lines = set.lines.count;
  std::vector<std::pair<double, std::size_t>> level(lines);
  for (std::size_t k = 0; k < lines; ++k) level[k].second = k;
  share_out_strips(lines, kCopied * set.outputs.size(), [&](std::size_t first, std::size_t count) {
    for (std::size_t o = 0; o < set.outputs.size(); ++o) {
      const double n = noise(static_cast<Index>(o)), factor = 1 / (n * n);
      const std::vector<Complex>& frf = set.outputs[o].frf;
      for (std::size_t k = first; k < first + count; ++k) level[k].first += factor * std::norm(frf[k]);
    }
  });
  const auto strong = level.begin() + static_cast<std::ptrdiff_t>(std::min(lines, kMostChosen));
  std::partial_sort(level.begin(), strong, level.end(), std::greater<>());
  const double least = kAboveNoise * static_cast<double>(set.outputs.size());
  std::size_t kept = 0;
  while (kept < std::min(lines, kMostChosen) && (kept < 2 * set.outputs.size() || level[kept].first > least)) ++kept;
  MatrixXd rows(static_cast<Index>(2 * kept), static_cast<Index>(set.outputs.size()));
  share_out(set.outputs.size(), kCopied * kept, [&](std::size_t o) {
    const auto column = static_cast<Index>(o);
    for (std::size_t i = 0; i < kept; ++i) {
      const Complex line = set.outputs[o].frf[level[i].second] / noise(column);
      rows(static_cast<Index>(i), column) = line.real();
      rows(static_cast<Index>(kept + i), column) = line.imag();
    }
  });
  return rows;
}

// Columns times columns, a strip of the result's lower half at a time: who takes eigenvectors looks at nothing else.
MatrixXd gram_of(const MatrixXd& rows) {
  MatrixXd gram = MatrixXd::Zero(rows.cols(), rows.cols());
  const Index strips = (rows.cols() + kColumns - 1) / kColumns;
  share_out(static_cast<std::size_t>(strips), static_cast<std::size_t>(2 * rows.size() * kColumns),
            [&](std::size_t strip) {
              const Index first = static_cast<Index>(strip) * kColumns, count = std::min(kColumns, rows.cols() - first);
              const Index below = rows.cols() - first;
              gram.block(first, first, below, count).noalias() =
                  rows.rightCols(below).transpose() * rows.middleCols(first, count);
            });
  return gram;
}

}  // namespace

MatrixXd principal_sums(const FrfSet& set, std::size_t most) {
  const VectorXd noise = LineNoise(set).over(0, set.lines.count);
  const MatrixXd directions = eigenvectors(gram_of(standing_out(set, noise)));
  const auto kept = static_cast<Index>(std::min(set.outputs.size(), most));
  return directions.leftCols(kept).array().colwise() / noise.array();
}

FrfSet mixed_outputs(const FrfSet& set, const MatrixXd& sums) {
  FrfSet mixed{.lines = set.lines, .reach_Hz = set.reach_Hz};
  PointForce force = set.points.front();
  force.noise_N = 0;
  for (Index i = 0; i < sums.cols(); ++i) {
    Output& output = mixed.outputs.emplace_back();
    output.channel = static_cast<std::size_t>(i);
    output.frf.resize(set.lines.count);
  }
  // A strip of all outputs stays near the processor while every sum is made of it.
  const std::size_t operations = kPerProduct * set.outputs.size() * mixed.outputs.size();
  share_out_strips(set.lines.count, operations, [&](std::size_t first, std::size_t count) {
    for (std::size_t p = 1; p < set.points.size() && !force.ff.empty(); ++p) {
      for (std::size_t k = first; k < first + count; ++k) force.ff[k] += set.points[p].ff[k];
    }
    for (Index i = 0; i < sums.cols(); ++i) {
      Eigen::Map<Eigen::VectorXcd> sum(mixed.outputs[static_cast<std::size_t>(i)].frf.data() + first,
                                       static_cast<Index>(count));
      for (Index o = 0; o < sums.rows(); ++o) {
        const auto& frf = set.outputs[static_cast<std::size_t>(o)].frf;
        sum += sums(o, i) * Eigen::Map<const Eigen::VectorXcd>(frf.data() + first, sum.size());
      }
    }
  });
  mixed.points.push_back(std::move(force));
  return mixed;
}

}  // namespace percuss
