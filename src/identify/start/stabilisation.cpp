#include "identify/start/stabilisation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/statistics.hpp"

namespace percuss::identify {
namespace {

constexpr double kSame = 0.5;                   // half-power bandwidths within a cluster
constexpr std::size_t kHalfSegmentLines = 512;  // half of a segment; segments overlap by half
constexpr std::size_t kStretchOrder = 32;
constexpr double kDeviationOfMedian = 1.4826022185056;  // [2]

double width_Hz(const Pole& a, const Pole& b) { return std::max(a.half_power_Hz(), b.half_power_Hz()); }
double apart_Hz(const Pole& a, const Pole& b) { return std::abs(a.freq_Hz - b.freq_Hz); }

Stability compare(const Pole& pole, const std::vector<Pole>& before, const StabilisationOptions& options) {
  const Pole* nearest = nullptr;
  for (const Pole& other : before) {
    if (nearest == nullptr || apart_Hz(pole, other) < apart_Hz(pole, *nearest)) nearest = &other;
  }
  if (nearest == nullptr || apart_Hz(pole, *nearest) > kSame * width_Hz(pole, *nearest)) return Stability::fresh;
  const bool frequency = apart_Hz(pole, *nearest) <= options.frequency_bandwidths * width_Hz(pole, *nearest);
  const bool damping =
      std::abs(pole.damping_ratio - nearest->damping_ratio) <= options.damping * nearest->damping_ratio;
  if (frequency) return damping ? Stability::stable : Stability::frequency;
  return damping ? Stability::damping : Stability::fresh;
}

double spread(std::vector<double> values) {
  const double middle = median(values);
  for (double& value : values) value = std::abs(value - middle);
  return kDeviationOfMedian * median(values);
}

struct Members {
  Pole last;                    // pole of the last order
  std::size_t order = 0;        // the last order
  std::vector<double> freq_Hz;  // of the stable poles
  std::vector<double> damping;
};

PoleCluster summary_of(const Members& members) {
  return {.pole = {.freq_Hz = median(members.freq_Hz), .damping_ratio = median(members.damping)},
          .stable = members.freq_Hz.size(),
          .freq_spread_Hz = spread(members.freq_Hz),
          .damping_spread = spread(members.damping)};
}

// The nearest cluster without a pole of this order.
Members& cluster_of(std::vector<Members>& clusters, const StabilisationPole& pole) {
  Members* nearest = nullptr;
  for (Members& cluster : clusters) {
    const double apart = apart_Hz(pole.pole, cluster.last);
    if (cluster.order == pole.order || apart > kSame * width_Hz(pole.pole, cluster.last)) continue;
    if (nearest == nullptr || apart < apart_Hz(pole.pole, nearest->last)) nearest = &cluster;
  }
  return nearest != nullptr ? *nearest : clusters.emplace_back();
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

std::vector<PoleCluster> cluster_poles(const Stabilisation& diagram, const StabilisationOptions& options) {
  std::vector<Members> clusters;
  for (const StabilisationPole& pole : diagram.poles) {
    Members& cluster = cluster_of(clusters, pole);
    cluster.last = pole.pole;
    cluster.order = pole.order;
    if (pole.stability != Stability::stable) continue;
    cluster.freq_Hz.push_back(pole.pole.freq_Hz);
    cluster.damping.push_back(pole.pole.damping_ratio);
  }
  std::vector<PoleCluster> out;
  for (const Members& cluster : clusters) {
    if (!cluster.freq_Hz.empty() && cluster.freq_Hz.size() >= options.min_stable) out.push_back(summary_of(cluster));
  }
  std::sort(out.begin(), out.end(),
            [](const PoleCluster& a, const PoleCluster& b) { return a.pole.freq_Hz < b.pole.freq_Hz; });
  return out;
}

std::vector<Pole> stabilised_candidates(const FrfDataset& set) {
  std::vector<Pole> poles;
  const std::size_t count = set.lines.count;
  for (std::size_t begin = 0; begin < count; begin += kHalfSegmentLines) {
    const std::size_t margin = std::min(begin, kHalfSegmentLines / 2);
    const std::size_t first = begin - margin;
    const std::size_t end = std::min(count, begin + kHalfSegmentLines + kHalfSegmentLines / 2);
    const StabilisationOptions options{.lscf = {.max_order = kStretchOrder, .first = first, .count = end - first}};
    const double low_Hz = begin == 0 ? 0 : set.lines.freq_Hz(begin);
    const double high_Hz = set.lines.freq_Hz(std::min(count, begin + kHalfSegmentLines));
    for (const PoleCluster& cluster : cluster_poles(stabilise(set, options), options)) {
      if (cluster.pole.freq_Hz >= low_Hz && cluster.pole.freq_Hz < high_Hz) poles.push_back(cluster.pole);
    }
  }
  return poles;
}

}  // namespace percuss::identify
