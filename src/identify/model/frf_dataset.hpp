#pragma once
#include <cstddef>
#include <vector>

#include "identify/model/modal_model.hpp"

namespace percuss::identify {

/// One FRF to be fitted: the response `channel` to hits at points[point].
struct FrfChannel {
  std::size_t point = 0;     // index into FrfDataset::points
  std::size_t channel = 0;   // acceleration channel
  std::vector<Complex> frf;  // H1 [lines]
};

/// Everything identification works on. All channels share the lines; channels of one point share its hits.
struct FrfDataset {
  frf::LineRange lines;
  double usable_bandwidth_Hz = 0;  // where the force has fallen by 20 dB; 0: not known
  std::vector<PointForce> points;
  std::vector<FrfChannel> channels;
  /// Of the exponential window, one for all points; 0 without one.
  double window_decay_per_s() const { return points.empty() ? 0 : points.front().window_decay_per_s(); }
};

/// Σ|H|² over all channels at one line, (m/s²)²/N²
inline double power_at(const FrfDataset& set, std::size_t line) {
  double power = 0;
  for (const FrfChannel& channel : set.channels) power += std::norm(channel.frf[line]);
  return power;
}

}  // namespace percuss::identify
