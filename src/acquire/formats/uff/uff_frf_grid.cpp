#include "acquire/formats/uff/uff_frf_grid.hpp"

#include <algorithm>
#include <cstdlib>

namespace percuss::acquire {
namespace {

// Whether each FRF has a point and a channel of its own.
bool is_unique(const UffFrfGrid& grid, const UffFrfs& frfs) {
  std::set<std::tuple<std::pair<int, int>, UffDofKey>> seen;
  return std::all_of(frfs.begin(), frfs.end(), [&](const UffFunction* f) {
    const auto point = grid.sensor_roves ? std::pair{f->response.node, 0} : uff_struck_key(*f);
    return seen.emplace(point, grid.channel_key(*f)).second;
  });
}

// A direction and its opposite are one degree of freedom. Names tell fixed sensors apart. The names of roving sensors,
// and the signs of directions, count only if two FRFs would otherwise have the same point and channel.
void choose_channel_key(UffFrfGrid& grid, const UffFrfs& frfs) {
  for (const auto& [by_name, by_sign] : {std::pair{false, false}, std::pair{true, false}, std::pair{true, true}}) {
    if (!by_name && !grid.sensor_roves) continue;
    grid.by_name = by_name;
    grid.by_sign = by_sign;
    if (is_unique(grid, frfs)) return;
  }
}

}  // namespace

UffDofKey uff_dof_key(const UffDof& dof) { return {dof.name, dof.node, dof.direction}; }

std::pair<int, int> uff_struck_key(const UffFunction& f) { return {f.reference.node, std::abs(f.reference.direction)}; }

UffDofKey UffFrfGrid::channel_key(const UffFunction& f) const {
  const UffDof& at = f.response;
  return {by_name ? at.name : "", sensor_roves ? 0 : at.node, by_sign ? at.direction : std::abs(at.direction)};
}

UffFrfGrid uff_frf_grid(const UffFrfs& frfs, const UffStruckSet& struck) {
  UffFrfGrid grid;
  std::set<int> sensed;
  for (const UffFunction* f : frfs) sensed.insert(f->response.node);
  grid.sensor_roves = struck.size() == 1 && sensed.size() > 1;
  choose_channel_key(grid, frfs);
  for (const UffFunction* f : frfs) grid.channels.emplace(grid.channel_key(*f), 0);
  std::size_t next = 0;
  for (const UffFunction* f : frfs) {  // numbered in the file's order
    auto& number = grid.channels.at(grid.channel_key(*f));
    if (number == 0) number = ++next;
  }
  return grid;
}

}  // namespace percuss::acquire
