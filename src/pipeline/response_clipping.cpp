#include "pipeline/response_clipping.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace percuss::pipeline {
namespace {

constexpr double kChance = 1e-3;  // of hits that agree so well and show no rail
constexpr double kAlike = 0.1;    // of the largest sample: by how much the two sides of a response differ, roughly

struct Side {
  std::size_t channel = 0;
  double sign = 1;
  bool shown_by(const AnalysedHit& hit) const { return channel < hit.responses.size() && !hit.responses[channel].dead; }
  double furthest(const AnalysedHit& hit) const {
    const Extremes& extremes = hit.responses[channel].extremes;
    return sign > 0 ? extremes.high : -extremes.low;
  }
  double other(const AnalysedHit& hit) const { return Side{channel, -sign}.furthest(hit); }
};

// How many sets of `some` out of `all` there are.
double choices(std::size_t all, std::size_t some) {
  double count = 1;
  for (std::size_t i = 0; i < some; ++i) count *= static_cast<double>(all - i) / static_cast<double>(some - i);
  return count;
}

void mark(acquire::ResponseGrade& response) {
  response.clipped_samples = std::max<std::size_t>(response.clipped_samples, 1);
}

void grade_side(std::vector<AnalysedHit>& hits, const Side& side) {
  std::vector<AnalysedHit*> shown;
  for (AnalysedHit& hit : hits) {
    if (side.shown_by(hit)) shown.push_back(&hit);
  }
  if (shown.size() < 2) return;
  const auto less = [&](const AnalysedHit* a, const AnalysedHit* b) { return side.furthest(*a) < side.furthest(*b); };
  const double rail = side.furthest(**std::max_element(shown.begin(), shown.end(), less));
  std::vector<AnalysedHit*> there;
  double step = 0, low = side.other(*shown.front()), high = low;
  for (AnalysedHit* hit : shown) {
    if (side.furthest(*hit) == rail) there.push_back(hit);
    step = std::max(step, hit->responses[side.channel].resolution);
    low = std::min(low, side.other(*hit));
    high = std::max(high, side.other(*hit));
  }
  // The other side tells by how much hits differ: blows of a machine may agree to the last bit.
  if (there.size() < 2 || !(high > low)) return;
  const double chance = choices(shown.size(), there.size()) *
                        std::pow(std::min(1.0, step / (high - low)), static_cast<double>(there.size() - 1));
  if (chance > kChance) return;
  for (AnalysedHit* hit : there) mark(hit->responses[side.channel]);
}

// Rails lie at the same distance to either side, and where they do for one channel they may for another.
std::set<double> clip_levels_of(const std::vector<AnalysedHit>& hits) {
  std::set<double> rails;
  for (const AnalysedHit& hit : hits) {
    for (const acquire::ResponseGrade& response : hit.responses) {
      const auto [low, high] = response.extremes;
      const bool even = high > 0 && high == -low && response.resolution < kChance * kAlike * high;
      if (even || response.clipped_samples > 0) rails.insert(std::max(high, -low));
    }
  }
  return rails;
}

}  // namespace

void grade_repeated_clipping(std::vector<AnalysedHit>& hits) {
  std::size_t channels = 0;
  for (const AnalysedHit& hit : hits) channels = std::max(channels, hit.responses.size());
  for (std::size_t c = 0; c < channels; ++c) {
    for (const double sign : {1.0, -1.0}) grade_side(hits, {.channel = c, .sign = sign});
  }
  const std::set<double> rails = clip_levels_of(hits);
  for (AnalysedHit& hit : hits) {
    for (acquire::ResponseGrade& response : hit.responses) {
      if (rails.contains(response.extremes.high) || rails.contains(-response.extremes.low)) mark(response);
    }
  }
}

}  // namespace percuss::pipeline
