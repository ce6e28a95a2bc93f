#include "metrics/deflection/impact_onset.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/math/statistics.hpp"

namespace percuss::metrics {
namespace {

constexpr double kLowest = 4;                     // standard deviations of the noise
constexpr double kHighest = 0.25;                 // of the first extreme
constexpr double kClearExtreme = 0.2;             // of the largest sample
constexpr std::array<double, 2> kPowers{1, 1.5};  // p of (1): spring, Hertz contact

struct Intercept {
  double sample = 0, std = 0;
};

// The first extreme that is clear of precursors, as a magnitude.
double first_extreme(std::span<const double> x, std::size_t first) {
  const double clear = kClearExtreme * extremes_of(x).max_distance_from(0);
  for (std::size_t i = first; i + 1 < x.size(); ++i) {
    if (std::abs(x[i]) >= clear && std::abs(x[i + 1]) < std::abs(x[i])) return std::abs(x[i]);
  }
  return extremes_of(x).max_distance_from(0);
}

// Where the straight line through |x|^(1/p) meets zero, weighted by the noise.
std::optional<Intercept> intercept(std::span<const double> x, std::size_t from, std::size_t to, double power,
                                   double noise) {
  double w = 0, wt = 0, wy = 0, wtt = 0, wty = 0;
  for (std::size_t i = from; i < to; ++i) {
    const double size = std::abs(x[i]), y = std::pow(size, 1 / power);
    const double slope = y / (power * size);  // dy/dx
    const double weight = 1 / (slope * slope), t = static_cast<double>(i - from);
    w += weight;
    wt += weight * t;
    wy += weight * y;
    wtt += weight * t * t;
    wty += weight * t * y;
  }
  const double det = w * wtt - wt * wt;
  if (!(det > 0)) return std::nullopt;
  const double rise = (w * wty - wt * wy) / det, level = (wtt * wy - wt * wty) / det;
  if (!(rise > 0)) return std::nullopt;
  const double at = -level / rise;
  // The variance of −level/rise, for samples whose noise has the standard deviation `noise`.
  const double variance = noise * noise * (wtt - 2 * wt * at + w * at * at) / det / (rise * rise);
  return Intercept{.sample = static_cast<double>(from) + at, .std = std::sqrt(std::max(0.0, variance))};
}

}  // namespace

ImpactOnset impact_onset(std::span<const double> x, double fs_Hz, std::size_t first, double noise) {
  const double between = 1 / std::sqrt(12.0), extreme = first_extreme(x, std::min(first, x.size()));
  // The rise leads to the extreme without a sample within the noise.
  std::size_t from = first;
  while (from < x.size() && std::abs(x[from]) < extreme) ++from;
  if (from >= x.size()) return {.time_s = (static_cast<double>(first) - 0.5) / fs_Hz, .std_s = between / fs_Hz};
  const double sign = std::copysign(1.0, x[from]);
  while (from > 0 && sign * x[from - 1] > kLowest * noise) --from;
  const ImpactOnset unknown{.time_s = (static_cast<double>(from) - 0.5) / fs_Hz, .std_s = between / fs_Hz};
  std::size_t to = from;
  while (to < x.size() && sign * x[to] > 0 && std::abs(x[to]) <= kHighest * extreme) ++to;
  if (to < from + 2) to = from + 2;
  if (to > x.size() || !(sign * x[to - 1] > std::abs(x[from]))) return unknown;
  const auto spring = intercept(x, from, to, kPowers[0], noise), hertz = intercept(x, from, to, kPowers[1], noise);
  if (!spring || !hertz) return unknown;
  const double half = std::abs(spring->sample - hertz->sample) / 2;
  const double at = (spring->sample + hertz->sample) / 2;
  if (!(at < static_cast<double>(from)) || !std::isfinite(at)) return unknown;
  return {.time_s = at / fs_Hz, .std_s = std::hypot(half, spring->std, 1e-6) / fs_Hz};
}

}  // namespace percuss::metrics
