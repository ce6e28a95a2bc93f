#include "pipeline/hits/response_clipping.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace percuss::pipeline {
namespace {

constexpr double kMaxChance = 1e-3;  // probability of equal extremes without clipping
constexpr double kAsymmetry = 0.1;   // typical difference between a response's extremes, relative to its largest sample

// The positive or the negative side of one channel.
struct Side {
  std::size_t channel = 0;
  double sign = 1;
  bool measured_by(const AnalysedHit& hit) const {
    return channel < hit.responses.size() && !hit.responses[channel].dead;
  }
  double extreme(const AnalysedHit& hit) const {
    const Extremes& extremes = hit.responses[channel].extremes;
    return sign > 0 ? extremes.high : -extremes.low;
  }
  double opposite(const AnalysedHit& hit) const { return Side{channel, -sign}.extreme(hit); }
};

// Binomial coefficient.
double combinations(std::size_t all, std::size_t some) {
  double count = 1;
  for (std::size_t i = 0; i < some; ++i) count *= static_cast<double>(all - i) / static_cast<double>(some - i);
  return count;
}

void mark_clipped(acquire::ResponseGrade& response) {
  response.clipped_samples = std::max<std::size_t>(response.clipped_samples, 1);
}

// Whether two rows hold one hit recorded twice. Equal extremes say nothing then.
bool is_copy(const AnalysedHit& a, const AnalysedHit& b, std::size_t channel) {
  return a.hit.peak_N == b.hit.peak_N && a.hit.gated_N == b.hit.gated_N &&
         a.responses[channel].extremes.high == b.responses[channel].extremes.high &&
         a.responses[channel].extremes.low == b.responses[channel].extremes.low;
}

void grade_side(std::vector<AnalysedHit>& hits, const Side& side) {
  std::vector<AnalysedHit*> measured;  // each hit once
  for (AnalysedHit& hit : hits) {
    const auto is_copy_of = [&](const AnalysedHit* other) { return is_copy(hit, *other, side.channel); };
    if (side.measured_by(hit) && std::none_of(measured.begin(), measured.end(), is_copy_of)) measured.push_back(&hit);
  }
  if (measured.size() < 2) return;
  const auto less = [&](const AnalysedHit* a, const AnalysedHit* b) { return side.extreme(*a) < side.extreme(*b); };
  const double level = side.extreme(**std::max_element(measured.begin(), measured.end(), less));
  std::vector<AnalysedHit*> at_level;
  double step = 0, low = side.opposite(*measured.front()), high = low;
  for (AnalysedHit* hit : measured) {
    if (side.extreme(*hit) == level) at_level.push_back(hit);
    step = std::max(step, hit->responses[side.channel].resolution);
    low = std::min(low, side.opposite(*hit));
    high = std::max(high, side.opposite(*hit));
  }
  // The extremes of the opposite side show by how much hits differ: the hits of an impact machine may be equal.
  if (at_level.size() < 2 || !(high > low)) return;
  const double chance = combinations(measured.size(), at_level.size()) *
                        std::pow(std::min(1.0, step / (high - low)), static_cast<double>(at_level.size() - 1));
  if (chance > kMaxChance) return;
  for (AnalysedHit* hit : at_level) mark_clipped(hit->responses[side.channel]);
}

// Clipping levels are equal in magnitude on both sides, and often equal for all channels.
std::set<double> clip_levels_of(const std::vector<AnalysedHit>& hits) {
  std::set<double> levels;
  for (const AnalysedHit& hit : hits) {
    for (const acquire::ResponseGrade& response : hit.responses) {
      const auto [low, high] = response.extremes;
      const bool even = high > 0 && high == -low && response.resolution < kMaxChance * kAsymmetry * high;
      if (even || response.clipped_samples > 0) levels.insert(std::max(high, -low));
    }
  }
  return levels;
}

}  // namespace

void grade_repeated_clipping(std::vector<AnalysedHit>& hits) {
  std::size_t channels = 0;
  for (const AnalysedHit& hit : hits) channels = std::max(channels, hit.responses.size());
  for (std::size_t c = 0; c < channels; ++c) {
    for (const double sign : {1.0, -1.0}) grade_side(hits, {.channel = c, .sign = sign});
  }
  const std::set<double> levels = clip_levels_of(hits);
  for (AnalysedHit& hit : hits) {
    for (acquire::ResponseGrade& response : hit.responses) {
      if (levels.contains(response.extremes.high) || levels.contains(-response.extremes.low)) mark_clipped(response);
    }
  }
}

}  // namespace percuss::pipeline
