#include "acquire/hits/clipping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace percuss::acquire {
namespace {

constexpr std::size_t kMinRun = 3;
// In steps: a quantised parabola with three equal samples falls by at most 4 beside them.
constexpr double kSmoothPeak = 5;
constexpr std::size_t kMinPeaks = 4;
constexpr double kPairFall = 1000;   // steps: the signal falls by more on either side of a clipped pair
constexpr double kSymmetric = 1e-3;  // difference of the falls on either side, over the larger one
// A quantised oscillation has twice as many samples within kNearSteps steps of its largest value as at that value. A
// clipped oscillation has fewer than half as many.
constexpr double kNearSteps = 4.5, kMaxNearRatio = 0.5;

// The samples at an extreme: their number, the number of separate peaks, and the length of the longest run.
struct PeakCount {
  std::size_t samples = 0, peaks = 0, longest_run = 0;
};

// Reads only the blocks whose extreme is `value`.
PeakCount count_peaks(std::span<const double> x, std::span<const Extremes> blocks, double value) {
  PeakCount out;
  std::size_t run = 0, last = 0;  // length and last sample of the current run
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].low != value && blocks[b].high != value) continue;
    const std::size_t end = std::min(x.size(), (b + 1) * kClippingBlock);
    for (std::size_t i = b * kClippingBlock; i < end; ++i) {
      if (x[i] != value) continue;
      const bool continues = run > 0 && last + 1 == i;
      run = continues ? run + 1 : 1;
      last = i;
      ++out.samples;
      out.peaks += continues ? 0 : 1;
      out.longest_run = std::max(out.longest_run, run);
    }
  }
  return out;
}

// The number of samples within `distance` of an extreme, excluding the samples at the extreme.
std::size_t count_near(std::span<const double> x, std::span<const Extremes> blocks, double value, double distance) {
  std::size_t count = 0;
  const auto near = [&](double a) { return a != value && std::abs(a - value) <= distance; };
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (std::min(std::abs(blocks[b].low - value), std::abs(blocks[b].high - value)) > distance) continue;
    const auto block = x.subspan(b * kClippingBlock, std::min(kClippingBlock, x.size() - b * kClippingBlock));
    count += static_cast<std::size_t>(std::count_if(block.begin(), block.end(), near));
  }
  return count;
}

bool is_flat_topped(std::span<const double> x, std::span<const Extremes> blocks, double value, double step,
                    const PeakCount& count) {
  if (count.peaks < kMinPeaks) return false;
  const auto near = static_cast<double>(count_near(x, blocks, value, kNearSteps * step));
  return near < kMaxNearRatio * static_cast<double>(count.samples);
}

// The number of samples at `level` in runs that a smooth peak cannot have.
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
  std::optional<double> resolution;  // computed on demand, which is rare
  std::size_t found = 0;
  const Extremes extremes = extremes_of(blocks);
  for (const double level : {extremes.low, extremes.high}) {
    if (level == rest) continue;
    const PeakCount count = count_peaks(x, blocks, level);
    if (count.longest_run < kMinRun && count.peaks < kMinPeaks) continue;
    if (!resolution) resolution = resolution_of(around);
    if (!(*resolution > 0)) return 0;
    found +=
        is_flat_topped(x, blocks, level, *resolution, count) ? count.samples : samples_in_runs(x, level, *resolution);
  }
  return found;
}

bool is_flat_pair(std::span<const double> pulse, std::span<const double> around) {
  const auto top = static_cast<std::size_t>(
      std::max_element(pulse.begin(), pulse.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      pulse.begin());
  if (pulse.empty() || top == 0 || top + 2 >= pulse.size() || pulse[top + 1] != pulse[top]) return false;
  const double before = std::abs(pulse[top] - pulse[top - 1]), after = std::abs(pulse[top] - pulse[top + 2]);
  // A computed pulse may be symmetric about the middle of its two largest samples.
  if (std::abs(before - after) < kSymmetric * std::max(before, after)) return false;
  const double step = resolution_of(around);
  return step > 0 && std::min(before, after) > kPairFall * step;
}

}  // namespace percuss::acquire
