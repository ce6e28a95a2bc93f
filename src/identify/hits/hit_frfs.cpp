#include "identify/hits/hit_frfs.hpp"

#include <numeric>

#include "core/math/complex.hpp"

namespace percuss::identify {

using Eigen::Index;
using Eigen::VectorXcd;

std::vector<std::size_t> residue_indices(const FrfDataset& set, const HitFrfs& hits) {
  const std::size_t channels = hits.set.channels.size() / hits.points.size();
  std::vector<std::size_t> first(set.points.size());
  for (std::size_t o = set.channels.size(); o-- > 0;) first[set.channels[o].point] = o;
  std::vector<std::size_t> of;
  for (const std::size_t point : hits.points) {
    for (std::size_t c = 0; c < channels; ++c) of.push_back(first[point] + c);
  }
  return of;
}

std::vector<VectorXcd> hit_data(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes,
                                const ModeWindow& window, const std::vector<Mode>& modes_in_hits) {
  std::vector<VectorXcd> data(hits.accel.size(), VectorXcd(static_cast<Index>(window.count)));
  for (std::size_t o = 0; o < data.size(); ++o) {
    const Complex* force = hits.set.points[hits.set.channels[o].point].spectra.front().get() + window.first;
    const Complex* accel = hits.accel[o].data() + window.first;
    for (std::size_t k = 0; k < window.count; ++k)
      data[o](static_cast<Index>(k)) = conj_times(force[k], accel[k]) * (1 / std::norm(force[k]));
  }
  if (modes_in_hits.empty()) {
    subtract_other_modes(hits.set, modes, window, residue_indices(set, hits), data);
  } else {
    std::vector<std::size_t> same(data.size());
    std::iota(same.begin(), same.end(), std::size_t{0});
    subtract_other_modes(hits.set, modes_in_hits, window, same, data);
  }
  return data;
}

}  // namespace percuss::identify
