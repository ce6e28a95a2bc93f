#include "pipeline/findings/recorded_window.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"
#include "core/units.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMinBlocks = 16;     // of a response after the hit; Hann window: in the last half
constexpr double kMinFall = 0.15;          // of the logarithm over the fitted part: 14 %
constexpr double kMaxEnd = 0.7;            // of the level before the hit; windows of recorders fall further
constexpr double kClear = 8;               // standard deviations of the decay
constexpr double kMaxMismatch = 0.15;      // of the logarithm of the level at the hit
constexpr double kMaxCurvature = 0.12;     // of the logarithm: difference of the halves' falls, relative
constexpr double kMaxTaperScatter = 0.15;  // of the logarithm of the noise over a Hann window, in the last half
constexpr double kTaperEnd = 0.97;         // of the record: end of the part that is compared

// Logarithm of the median level over the responses, relative to the noise before the hit, by block.
struct LogLevels {
  std::vector<double> time_s, level;
};

// A straight line through the levels of blocks [first, end).
struct Line {
  double slope = 0, slope_std = 0, at_zero = 0, at_zero_std = 0;
};
Line fitted_line(const LogLevels& levels, std::size_t first, std::size_t end) {
  const auto n = static_cast<double>(end - first);
  double t0 = 0, y0 = 0;
  for (std::size_t i = first; i < end; ++i) {
    t0 += levels.time_s[i] / n;
    y0 += levels.level[i] / n;
  }
  double tt = 0, ty = 0;
  for (std::size_t i = first; i < end; ++i) {
    const double t = levels.time_s[i] - t0;
    tt += t * t;
    ty += t * (levels.level[i] - y0);
  }
  Line line{.slope = ty / tt};
  line.at_zero = y0 - line.slope * t0;
  double square = 0;
  for (std::size_t i = first; i < end; ++i) {
    const double off = levels.level[i] - line.at_zero - line.slope * levels.time_s[i];
    square += off * off;
  }
  const double std = std::sqrt(square / (n - 2));
  line.slope_std = std / std::sqrt(tt);
  line.at_zero_std = std * std::sqrt(1 / n + t0 * t0 / tt);
  return line;
}

std::size_t common_blocks(const std::vector<NoiseHistory>& responses) {
  std::size_t blocks = responses.empty() ? 0 : responses.front().after.rms.size();
  for (const NoiseHistory& response : responses) blocks = std::min(blocks, response.after.rms.size());
  return blocks;
}

// The noise at the end over the noise in the middle, where the last half follows a Hann window; else nothing.
std::optional<double> hann_end_level(const std::vector<NoiseHistory>& responses, std::size_t blocks) {
  const auto& first = responses.front().after;
  const double samples = static_cast<double>(first.first + (blocks + 1) * kDifferenceBlock);
  std::vector<double> off;
  double end = 0, middle = 0;
  for (std::size_t b = blocks / 2; b < blocks; ++b) {
    const double share =
        (static_cast<double>(first.first) + (static_cast<double>(b) + 0.5) * kDifferenceBlock) / samples;
    std::vector<double> levels;
    for (const NoiseHistory& response : responses) levels.push_back(response.after.rms[b]);
    end = median(levels);
    if (b == blocks / 2) middle = end;
    if (share < 0.5 || share > kTaperEnd) continue;
    if (!(end > 0)) return std::nullopt;
    off.push_back(std::log(end / (0.5 - 0.5 * std::cos(kTwoPi * share))));
  }
  if (off.size() < kMinBlocks || robust_std(off) > kMaxTaperScatter || !(middle > 0)) return std::nullopt;
  const Spread spread = spread_of(off);
  const auto far = [&](double value) { return std::abs(value - spread.median) > 5 * kMaxTaperScatter; };
  if (std::any_of(off.begin(), off.end(), far)) return std::nullopt;
  return end / middle;
}

LogLevels log_levels(const std::vector<NoiseHistory>& responses, std::size_t blocks, double hit_sample, double fs_Hz) {
  LogLevels out;
  for (std::size_t b = 0; b < blocks; ++b) {
    std::vector<double> levels;
    for (const NoiseHistory& response : responses) {
      if (response.before && *response.before > 0 && response.after.rms[b] > 0)
        levels.push_back(std::log(response.after.rms[b] / *response.before));
    }
    if (levels.empty()) return {};
    const auto middle = static_cast<double>(responses.front().after.first) +
                        (static_cast<double>(b) + 0.5) * static_cast<double>(kDifferenceBlock);
    out.time_s.push_back((middle - hit_sample) / fs_Hz);
    out.level.push_back(median(levels));
  }
  return out;
}

// Tolerance of the fitted level at the hit, with the error of the noise before the hit. Few samples determine this
// noise, so that its error falls only with the number of responses.
double start_tolerance(const std::vector<NoiseHistory>& responses, const Line& line) {
  return std::max(kMaxMismatch,
                  4 * std::hypot(line.at_zero_std, 0.25 / std::sqrt(static_cast<double>(responses.size()))));
}

}  // namespace

std::optional<RecordedWindow> find_recorded_window(const std::vector<NoiseHistory>& responses, double hit_sample,
                                                   double fs_Hz) {
  const std::size_t blocks = common_blocks(responses);
  if (blocks < kMinBlocks) return std::nullopt;
  const LogLevels levels = log_levels(responses, blocks, hit_sample, fs_Hz);
  if (!levels.level.empty()) {
    const std::size_t first = blocks / 3, middle = (first + blocks) / 2;
    const Line line = fitted_line(levels, first, blocks);
    const Line early = fitted_line(levels, first, middle), late = fitted_line(levels, middle, blocks);
    const double fall = -line.slope * (levels.time_s.back() - levels.time_s[first]);
    const bool straight = std::abs(early.slope - late.slope) <
                          std::max(-kMaxCurvature * line.slope, 4 * std::hypot(early.slope_std, late.slope_std));
    const double end_level = std::exp(line.at_zero + line.slope * levels.time_s.back());
    if (fall > kMinFall && end_level < kMaxEnd && -line.slope > kClear * line.slope_std && straight &&
        std::abs(line.at_zero) < start_tolerance(responses, line)) {
      return RecordedWindow{.decay_per_s = -line.slope, .decay_std_per_s = line.slope_std, .end_level = end_level};
    }
  }
  const std::optional<double> end = hann_end_level(responses, blocks);
  if (!end) return std::nullopt;
  return RecordedWindow{.exponential = false, .end_level = *end};
}

}  // namespace percuss::pipeline
