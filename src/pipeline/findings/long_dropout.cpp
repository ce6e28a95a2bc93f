#include "pipeline/findings/long_dropout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/findings/sample_faults.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMotion = 32;    // samples: two such stretches before a run show the motion and its decay
constexpr std::size_t kMinMotion = 8;  // samples of a stretch, soon after the pulse
constexpr double kMotion_steps = 8;    // peak to peak; the silence after a decay has one or two
constexpr double kCorner_steps = 8;    // second difference where a run begins or ends

double peak_to_peak(std::span<const double> x) {
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  return *high - *low;
}

// The smallest difference between neighbours that differ: the step of the recorder, or less.
double step_of(std::span<const double> x) {
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t n = 1; n < x.size(); ++n) {
    if (x[n] != x[n - 1]) step = std::min(step, std::abs(x[n] - x[n - 1]));
  }
  return step;
}

// The peak-to-peak motion expected within a run, extrapolated from the decay before it.
double expected_motion(std::span<const double> before) {
  const std::size_t count = std::min(kMotion, before.size() / 2);
  if (count < kMinMotion) return 0;
  const double last = peak_to_peak(before.last(count));
  const double earlier = peak_to_peak(before.last(2 * count).first(count));
  return last * std::min(1.0, last / earlier);
}

double second_difference(std::span<const double> x, std::size_t n) { return std::abs(x[n - 1] - 2 * x[n] + x[n + 1]); }

// The corners at the last sample before a run and at the first after it.
double largest_corner(std::span<const double> x, const LongDropout& run) {
  double corner = second_difference(x, run.first - 1);
  if (const std::size_t after = run.first + run.count; after + 1 < x.size())
    corner = std::max(corner, second_difference(x, after));
  return corner;
}

bool is_dropout(std::span<const double> x, std::size_t first, const LongDropout& run, double step) {
  const double motion = expected_motion(x.subspan(first, run.first - first));
  return motion >= kMotion_steps * step && largest_corner(x, run) >= kCorner_steps * step;
}

}  // namespace

std::optional<LongDropout> find_long_dropout(std::span<const double> x, std::size_t first) {
  std::optional<LongDropout> found;
  std::optional<double> step, largest;
  for (std::size_t n = first; n + kMaxFault < x.size();) {
    // A run of more than kMaxFault samples that begins at n … probe − 1 contains the samples probe − 1 and probe.
    const std::size_t probe = n + kMaxFault;
    if (x[probe] != x[probe - 1]) {
      n = probe;
      continue;
    }
    std::size_t begin = probe - 1, end = probe + 1;
    while (begin > n && x[begin - 1] == x[probe]) --begin;
    while (end < x.size() && x[end] == x[probe]) ++end;
    const LongDropout run{.first = begin, .count = end - begin, .to_end = end == x.size()};
    n = end;
    if (run.count <= kMaxFault || run.first < first + 2 * kMinMotion || (found && run.count <= found->count)) continue;
    if (!step) step = step_of(x);
    if (!largest) {
      const auto [low, high] = std::minmax_element(x.begin(), x.end());
      largest = std::max(std::abs(*low), std::abs(*high));
    }
    if (std::abs(x[run.first]) < *largest && is_dropout(x, first, run, *step)) found = run;
  }
  return found;
}

}  // namespace percuss::pipeline
