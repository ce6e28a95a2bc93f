#pragma once
#include <cstddef>
#include <vector>

#include "identify/model/modal_model.hpp"

namespace percuss::identify {

/// One measured FRF: the response of an acceleration channel to the hits at one impact point.
struct FrfChannel {
  std::size_t point = 0;     // index into FrfDataset::points
  std::size_t channel = 0;   // index of the acceleration channel
  std::vector<Complex> frf;  // [lines], (m/s²)/N; of hits: H1
};

/// The FRFs of a test. All FRFs share the spectral lines; the FRFs of one impact point share its hits.
struct FrfDataset {
  acquire::LineRange lines;
  double usable_bandwidth_Hz = 0;  // where the force has fallen by 20 dB; 0: unknown
  std::vector<PointForce> points;
  std::vector<FrfChannel> channels;
  /// Decay of the exponential window, the same for all points; 0 without a window.
  double window_decay_per_s() const { return points.empty() ? 0 : points.front().window_decay_per_s(); }
};

/// [points] the indices of each point's FRFs.
inline std::vector<std::vector<std::size_t>> channels_by_point(const FrfDataset& set) {
  std::vector<std::vector<std::size_t>> of(set.points.size());
  for (std::size_t o = 0; o < set.channels.size(); ++o) of[set.channels[o].point].push_back(o);
  return of;
}

/// Σ|H|² over all FRFs at one spectral line, (m/s²)²/N²
inline double power_at(const FrfDataset& set, std::size_t line) {
  double power = 0;
  for (const FrfChannel& channel : set.channels) power += std::norm(channel.frf[line]);
  return power;
}

}  // namespace percuss::identify
