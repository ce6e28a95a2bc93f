#include "identify/fit/principal_frfs.hpp"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "core/math/decompositions.hpp"
#include "core/math/tall_products.hpp"
#include "core/parallel/parallel.hpp"
#include "identify/noise/line_noise.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kAboveNoise = 20;  // smallest energy of a used line over all FRFs, relative to the noise
constexpr Index kColumnsPerTask = 16;
constexpr std::size_t kFlopsPerCopiedLine = 10;
constexpr std::size_t kMaxUsedLines = 1500;

// Each FRF divided by its noise, at the lines above the noise, and at the 2·channels strongest lines in any case: at
// most kMaxUsedLines lines, the strongest. Shape [2 lines, channels]: real parts, then imaginary.
MatrixXd lines_above_noise(const FrfDataset& set, const VectorXd& noise) {
  const std::size_t lines = set.lines.count;
  std::vector<std::pair<double, std::size_t>> level(lines);
  for (std::size_t k = 0; k < lines; ++k) level[k].second = k;
  parallel_for_chunks(lines, kFlopsPerCopiedLine * set.channels.size(), [&](std::size_t first, std::size_t count) {
    for (std::size_t o = 0; o < set.channels.size(); ++o) {
      const double n = noise(static_cast<Index>(o)), factor = 1 / (n * n);
      const std::vector<Complex>& frf = set.channels[o].frf;
      for (std::size_t k = first; k < first + count; ++k) level[k].first += factor * std::norm(frf[k]);
    }
  });
  const auto strong = level.begin() + static_cast<std::ptrdiff_t>(std::min(lines, kMaxUsedLines));
  std::partial_sort(level.begin(), strong, level.end(), std::greater<>());
  const double least = kAboveNoise * static_cast<double>(set.channels.size());
  std::size_t kept = 0;
  while (kept < std::min(lines, kMaxUsedLines) && (kept < 2 * set.channels.size() || level[kept].first > least)) ++kept;
  MatrixXd rows(static_cast<Index>(2 * kept), static_cast<Index>(set.channels.size()));
  parallel_for_cost(set.channels.size(), kFlopsPerCopiedLine * kept, [&](std::size_t o) {
    const auto column = static_cast<Index>(o);
    for (std::size_t i = 0; i < kept; ++i) {
      const Complex line = set.channels[o].frf[level[i].second] / noise(column);
      rows(static_cast<Index>(i), column) = line.real();
      rows(static_cast<Index>(kept + i), column) = line.imag();
    }
  });
  return rows;
}

// rowsᵀ·rows. Only the lower triangle is filled: the eigenvalue solver reads nothing else.
MatrixXd gram_of(const MatrixXd& rows) {
  MatrixXd gram = MatrixXd::Zero(rows.cols(), rows.cols());
  const Index strips = (rows.cols() + kColumnsPerTask - 1) / kColumnsPerTask;
  parallel_for_cost(static_cast<std::size_t>(strips), static_cast<std::size_t>(2 * rows.size() * kColumnsPerTask),
                    [&](std::size_t strip) {
                      const Index first = static_cast<Index>(strip) * kColumnsPerTask,
                                  count = std::min(kColumnsPerTask, rows.cols() - first);
                      const Index below = rows.cols() - first;
                      gram.block(first, first, below, count) =
                          tall_transposed_product(rows.rightCols(below), rows.middleCols(first, count));
                    });
  return gram;
}

}  // namespace

MatrixXd principal_components(const FrfDataset& set, std::size_t max_components) {
  const VectorXd noise = LineNoise(set).over(0, set.lines.count);
  const MatrixXd directions = eigenvectors(gram_of(lines_above_noise(set, noise)));
  const auto kept = static_cast<Index>(std::min(set.channels.size(), max_components));
  return directions.leftCols(kept).array().colwise() / noise.array();
}

FrfDataset principal_frfs(const FrfDataset& set, const MatrixXd& components) {
  FrfDataset out{.lines = set.lines, .usable_bandwidth_Hz = set.usable_bandwidth_Hz};
  const PointForce& one = set.points.front();
  PointForce force{.blocks = one.blocks, .spectra = {}, .ff = one.ff, .noise_N = 0, .complete = true};
  for (Index i = 0; i < components.cols(); ++i) {
    FrfChannel& channel = out.channels.emplace_back();
    channel.channel = static_cast<std::size_t>(i);
    channel.frf.resize(set.lines.count);
  }
  // In chunks of lines, which stay in the cache for all components.
  const std::size_t operations = kFlopsPerProduct * set.channels.size() * out.channels.size();
  parallel_for_chunks(set.lines.count, operations, [&](std::size_t first, std::size_t count) {
    for (std::size_t p = 1; p < set.points.size() && !force.ff.empty(); ++p) {
      for (std::size_t k = first; k < first + count; ++k) force.ff[k] += set.points[p].ff[k];
    }
    // Real and imaginary parts in turn, as a column of twice the length.
    const auto parts = static_cast<Index>(2 * count);
    MatrixXd frfs(parts, components.rows());
    for (Index o = 0; o < frfs.cols(); ++o) {
      const Complex* frf = set.channels[static_cast<std::size_t>(o)].frf.data() + first;
      frfs.col(o) = Eigen::Map<const VectorXd>(reinterpret_cast<const double*>(frf), parts);
    }
    const MatrixXd sums = tall_product(frfs, components);
    for (Index i = 0; i < sums.cols(); ++i) {
      Complex* frf = out.channels[static_cast<std::size_t>(i)].frf.data() + first;
      Eigen::Map<VectorXd>(reinterpret_cast<double*>(frf), parts) = sums.col(i);
    }
  });
  out.points.push_back(std::move(force));
  return out;
}

}  // namespace percuss::identify
