#include "identify/principal.hpp"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "core/principal_directions.hpp"
#include "identify/line_noise.hpp"

namespace percuss {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kAboveNoise = 20;  // energy of a line, over the noise of all outputs, from which it tells directions
constexpr std::size_t kMostChosen = 1500;  // … the strongest ones

// The outputs over their noise, real parts above imaginary parts of the lines that stand out: [2 lines, outputs].
MatrixXd standing_out(const FrfSet& set, const VectorXd& noise) {
  const std::size_t lines = set.lines.count;
  std::vector<std::pair<double, std::size_t>> level(lines);
  for (std::size_t k = 0; k < lines; ++k) {
    level[k].second = k;
    for (std::size_t o = 0; o < set.outputs.size(); ++o) {
      const double n = noise(static_cast<Index>(o));
      level[k].first += std::norm(set.outputs[o].frf[k]) / (n * n);
    }
  }
  std::sort(level.begin(), level.end(), std::greater<>());
  const double least = kAboveNoise * static_cast<double>(set.outputs.size());
  std::size_t kept = 0;
  while (kept < std::min(lines, kMostChosen) && (kept < 2 * set.outputs.size() || level[kept].first > least)) ++kept;
  MatrixXd rows(static_cast<Index>(2 * kept), static_cast<Index>(set.outputs.size()));
  for (std::size_t o = 0; o < set.outputs.size(); ++o) {
    const auto column = static_cast<Index>(o);
    for (std::size_t i = 0; i < kept; ++i) {
      const Complex line = set.outputs[o].frf[level[i].second] / noise(column);
      rows(static_cast<Index>(i), column) = line.real();
      rows(static_cast<Index>(kept + i), column) = line.imag();
    }
  }
  return rows;
}

}  // namespace

FrfSet principal_outputs(const FrfSet& set, std::size_t most) {
  const VectorXd noise = LineNoise(set).over(0, set.lines.count);
  const MatrixXd rows = standing_out(set, noise);
  const MatrixXd directions = eigenvectors(rows.transpose() * rows);
  const auto outputs = static_cast<Index>(set.outputs.size());
  const Index kept = std::min<Index>(outputs, static_cast<Index>(most));
  FrfSet mixed{.lines = set.lines, .reach_Hz = set.reach_Hz};
  PointForce force = set.points.front();
  force.noise_N = 0;
  for (std::size_t p = 1; p < set.points.size(); ++p) {
    for (std::size_t k = 0; k < force.ff.size(); ++k) force.ff[k] += set.points[p].ff[k];
  }
  mixed.points.push_back(std::move(force));
  for (Index i = 0; i < kept; ++i) {
    const VectorXd mix = directions.col(i).cwiseQuotient(noise);
    Output output{.point = 0, .channel = static_cast<std::size_t>(i), .frf = std::vector<Complex>(set.lines.count)};
    Eigen::Map<Eigen::VectorXcd> sum(output.frf.data(), static_cast<Index>(set.lines.count));
    for (Index o = 0; o < outputs; ++o) {
      const auto& frf = set.outputs[static_cast<std::size_t>(o)].frf;
      sum += mix(o) * Eigen::Map<const Eigen::VectorXcd>(frf.data(), sum.size());
    }
    mixed.outputs.push_back(std::move(output));
  }
  return mixed;
}

}  // namespace percuss
