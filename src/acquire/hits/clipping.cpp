#include "acquire/hits/clipping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace percuss::acquire {
namespace {

constexpr std::size_t kMinRun = 3;
constexpr double kSmoothPeak =
    5;  // steps: a quantised parabola with three equal samples falls by at most 4 beside them
constexpr std::size_t kMinTops = 4;
constexpr double kBelow = 4.5;     // steps; a quantised swing is there twice as often as at its largest value …
constexpr double kMaxBelow = 0.5;  // … and a clipped one less than half as often

// How often an extreme is reached: samples, separate tops, and the longest row of them.
struct PeakCount {
  std::size_t samples = 0, peaks = 0, row = 0;
};

// Only blocks that reach it as well are looked at.
PeakCount reached(std::span<const double> x, std::span<const Extremes> blocks, double value) {
  PeakCount out;
  std::size_t row = 0, last = 0;  // samples so far of a row, and the last one of it
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].low != value && blocks[b].high != value) continue;
    const std::size_t end = std::min(x.size(), (b + 1) * kClippingBlock);
    for (std::size_t i = b * kClippingBlock; i < end; ++i) {
      if (x[i] != value) continue;
      const bool goes_on = row > 0 && last + 1 == i;
      row = goes_on ? row + 1 : 1;
      last = i;
      ++out.samples;
      out.peaks += goes_on ? 0 : 1;
      out.row = std::max(out.row, row);
    }
  }
  return out;
}

// Samples between an extreme and `reach` below it (above, for the lowest).
std::size_t just_below(std::span<const double> x, std::span<const Extremes> blocks, double value, double reach) {
  std::size_t count = 0;
  const auto near = [&](double a) { return a != value && std::abs(a - value) <= reach; };
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (std::min(std::abs(blocks[b].low - value), std::abs(blocks[b].high - value)) > reach) continue;
    const auto block = x.subspan(b * kClippingBlock, std::min(kClippingBlock, x.size() - b * kClippingBlock));
    count += static_cast<std::size_t>(std::count_if(block.begin(), block.end(), near));
  }
  return count;
}

bool is_flat_topped(std::span<const double> x, std::span<const Extremes> blocks, double value, double step,
                    const PeakCount& there) {
  if (there.peaks < kMinTops) return false;
  const auto below = static_cast<double>(just_below(x, blocks, value, kBelow * step));
  return below < kMaxBelow * static_cast<double>(there.samples);
}

// Samples at the rail in rows that no smooth peak makes.
std::size_t samples_in_runs(std::span<const double> x, double level, double step) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < x.size();) {
    std::size_t n = i;
    while (n < x.size() && x[n] == level) ++n;
    if (n - i >= kMinRun) {
      const double before = i > 0 ? std::abs(x[i - 1] - level) : 0;
      const double after = n < x.size() ? std::abs(x[n] - level) : 0;
      if (std::max(before, after) > kSmoothPeak * step) found += n - i;
    }
    i = std::max(n, i + 1);
  }
  return found;
}

}  // namespace

double resolution_of(std::span<const double> x) {
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double change = std::abs(x[i] - x[i - 1]);
    if (change > 0) step = std::min(step, change);
  }
  return std::isfinite(step) ? step : 0;
}

std::size_t count_clipped_samples(std::span<const double> x, std::span<const Extremes> blocks,
                                  std::span<const double> around, double rest) {
  if (x.size() < 4) return 0;
  std::optional<double> resolution;  // found when asked for, which is seldom
  std::size_t found = 0;
  const Extremes extremes = extremes_of(blocks);
  for (const double level : {extremes.low, extremes.high}) {
    if (level == rest) continue;
    const PeakCount there = reached(x, blocks, level);
    if (there.row < kMinRun && there.peaks < kMinTops) continue;
    if (!resolution) resolution = resolution_of(around);
    if (!(*resolution > 0)) return 0;
    found +=
        is_flat_topped(x, blocks, level, *resolution, there) ? there.samples : samples_in_runs(x, level, *resolution);
  }
  return found;
}

}  // namespace percuss::acquire
