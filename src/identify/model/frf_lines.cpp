#include "identify/model/frf_lines.hpp"

namespace percuss::identify {
namespace {

template <class T>
std::vector<T> part_of(const std::vector<T>& values, std::size_t first, std::size_t count) {
  if (values.empty()) return {};
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

}  // namespace

FrfDataset lines_of(const FrfDataset& set, std::size_t first, std::size_t count) {
  FrfDataset part{.lines = set.lines, .usable_bandwidth_Hz = set.usable_bandwidth_Hz};
  part.lines.first += first;
  part.lines.count = count;
  for (const PointForce& point : set.points) {
    PointForce& its = part.points.emplace_back(
        PointForce{.blocks = point.blocks, .noise_N = point.noise_N, .complete = point.complete});
    its.ff = part_of(point.ff, first, count);
    for (const frf::Spectrum& spectrum : point.spectra) its.spectra.emplace_back(spectrum, spectrum.get() + first);
  }
  for (const FrfChannel& channel : set.channels) {
    part.channels.push_back(
        {.point = channel.point, .channel = channel.channel, .frf = part_of(channel.frf, first, count)});
  }
  return part;
}

PointSet set_of_point(const FrfDataset& all, std::size_t point) {
  PointSet one{.set = {.lines = all.lines,
                       .usable_bandwidth_Hz = all.usable_bandwidth_Hz,
                       .points = {all.points[point]},
                       .channels = {}},
               .channels = {}};
  for (std::size_t o = 0; o < all.channels.size(); ++o) {
    if (all.channels[o].point != point) continue;
    one.channels.push_back(o);
    one.set.channels.push_back({.point = 0, .channel = all.channels[o].channel, .frf = {}});
  }
  return one;
}

}  // namespace percuss::identify
