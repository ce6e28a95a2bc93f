#include "identify/start/truncation_ripples.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"

namespace percuss::identify {
namespace {

constexpr double kMinRippleTruncation = 0.1;  // amplitude at the record's end over its start
constexpr std::size_t kFlankFrom = 4,
                      kFlankUpTo = 16;        // lines from the peak: beyond its top, but mostly before other peaks
constexpr double kMaxRippleFactor = 2;        // height of a ripple over the flank's
constexpr double kMinRemainingEnergy = 0.25;  // residual energy over the FRFs' energy

// Height times distance in lines, which is constant along a flank.
double flank_height(const FrfDataset& set, std::size_t line) {
  std::vector<double> heights;
  for (std::size_t k = kFlankFrom; k <= kFlankUpTo; ++k) {
    if (line >= k) heights.push_back(std::sqrt(power_at(set, line - k)) * static_cast<double>(k));
    if (line + k < set.lines.count) heights.push_back(std::sqrt(power_at(set, line + k)) * static_cast<double>(k));
  }
  return median(std::move(heights));
}

}  // namespace

std::vector<char> find_truncation_ripples(const FrfDataset& set, const std::vector<Pole>& poles) {
  std::vector<char> doubtful(poles.size(), 0);
  for (std::size_t p = 0; p < poles.size(); ++p) {
    if (remaining_amplitude(poles[p], set.lines, set.window_decay_per_s()) < kMinRippleTruncation) continue;
    const std::size_t line = set.lines.nearest(poles[p].freq_Hz);
    const double flank = flank_height(set, line);
    for (std::size_t q = 0; q < poles.size(); ++q) {
      const std::size_t other = set.lines.nearest(poles[q].freq_Hz);
      const double power = power_at(set, other);
      const auto apart = static_cast<double>(std::max(line, other) - std::min(line, other));
      if (apart > 0 && power < power_at(set, line) && std::sqrt(power) * apart < kMaxRippleFactor * flank)
        doubtful[q] = 1;
    }
  }
  return doubtful;
}

bool remains_in_residual(const FrfDataset& set, const Pole& pole, const std::vector<Eigen::VectorXcd>& residual) {
  const std::size_t line = set.lines.nearest(pole.freq_Hz);
  double left = 0;
  for (const Eigen::VectorXcd& channel : residual) left += std::norm(channel(static_cast<Eigen::Index>(line)));
  return left > kMinRemainingEnergy * power_at(set, line);
}

}  // namespace percuss::identify
