#include "identify/fit/completed_decays.hpp"

#include <algorithm>

#include "core/math/tall_products.hpp"
#include "core/parallel/parallel.hpp"
#include "identify/model/point_columns.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr std::size_t kFlopsPerLine = 60;  // operations of a truncated decay

}  // namespace

CompletedDecays::CompletedDecays(const FrfDataset& cut)
    : cut_(cut), whole_{.lines = cut.lines, .usable_bandwidth_Hz = cut.usable_bandwidth_Hz} {
  whole_.points.resize(cut.points.size());
  parallel_for_cost(cut.points.size(), kFlopsPerProduct * cut.lines.count, [&](std::size_t p) {
    const PointForce& point = cut.points[p];
    whole_.points[p] = {.blocks = point.blocks, .spectra = {}, .ff = point.ff, .noise_N = point.noise_N};
    whole_.points[p].complete = true;
  });
  whole_.channels.resize(cut.channels.size());
  parallel_for_cost(cut.channels.size(), kFlopsPerProduct * cut.lines.count,
                    [&](std::size_t o) { whole_.channels[o] = cut.channels[o]; });
}

bool CompletedDecays::truncation_is_known(const FrfDataset& cut) {
  return std::all_of(cut.points.begin(), cut.points.end(), [](const PointForce& p) { return !p.blocks.empty(); });
}

void CompletedDecays::add_missing_decays(const std::vector<Pole>& poles, const Eigen::MatrixXcd& residues) {
  parallel_for_cost(cut_.channels.size(), kFlopsPerProduct * cut_.lines.count,
                    [&](std::size_t o) { whole_.channels[o].frf = cut_.channels[o].frf; });
  const auto channels = channels_by_point(cut_);
  for (std::size_t m = 0; m < poles.size(); ++m) {
    if (remaining_amplitude(poles[m], cut_.lines) < kMinTruncation) continue;
    const TruncatedDecay missing(poles[m], 0, cut_.lines, 0, cut_.lines.count);
    parallel_for_cost(channels.size(), kFlopsPerLine * cut_.lines.count, [&](std::size_t p) {
      if (channels[p].empty()) return;
      const std::vector<Complex> decay = missing.at(cut_.points[p]);
      for (const std::size_t o : channels[p])
        add_scaled(whole_.channels[o].frf.data(), residues(static_cast<Index>(o), static_cast<Index>(m)), decay.data(),
                   decay.size());
    });
  }
}

}  // namespace percuss::identify
