#include "identify/start/stabilisation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace percuss::identify {
namespace {

constexpr double kMaxDistance = 0.5;  // half-power bandwidths to the nearest pole of the previous order

double width_Hz(const Pole& a, const Pole& b) { return std::max(a.half_power_Hz(), b.half_power_Hz()); }
double apart_Hz(const Pole& a, const Pole& b) { return std::abs(a.freq_Hz - b.freq_Hz); }

Stability compare(const Pole& pole, const std::vector<Pole>& before, const StabilisationOptions& options) {
  const Pole* nearest = nullptr;
  for (const Pole& other : before) {
    if (nearest == nullptr || apart_Hz(pole, other) < apart_Hz(pole, *nearest)) nearest = &other;
  }
  if (nearest == nullptr || apart_Hz(pole, *nearest) > kMaxDistance * width_Hz(pole, *nearest)) return Stability::fresh;
  const bool frequency = apart_Hz(pole, *nearest) <= options.frequency_bandwidths * width_Hz(pole, *nearest);
  const bool damping =
      std::abs(pole.damping_ratio - nearest->damping_ratio) <= options.damping * nearest->damping_ratio;
  if (frequency) return damping ? Stability::stable : Stability::frequency;
  return damping ? Stability::damping : Stability::fresh;
}

}  // namespace

const char* name_of(Stability stability) {
  switch (stability) {
    case Stability::fresh:
      return "new";
    case Stability::frequency:
      return "frequency";
    case Stability::damping:
      return "damping";
    case Stability::stable:
      return "stable";
  }
  return "";
}

Stabilisation stabilise(const FrfDataset& set, const StabilisationOptions& options) {
  Stabilisation diagram;
  std::vector<Pole> before;
  for (LscfOrder& order : lscf_poles(set, options.lscf)) {
    for (const Pole& pole : order.poles)
      diagram.poles.push_back({.order = order.order, .pole = pole, .stability = compare(pole, before, options)});
    before = std::move(order.poles);
  }
  if (set.lines.count == 0) return diagram;
  const std::size_t first = std::min(options.lscf.first, set.lines.count - 1);
  const std::size_t left = set.lines.count - first;
  const std::size_t count = options.lscf.count == 0 ? left : std::min(options.lscf.count, left);
  diagram.low_Hz = set.lines.freq_Hz(first);
  diagram.high_Hz = set.lines.freq_Hz(first + count - 1);
  return diagram;
}

}  // namespace percuss::identify
