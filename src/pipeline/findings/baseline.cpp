#include "pipeline/findings/baseline.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/statistics.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMinQuiet = 16;  // samples
constexpr std::size_t kRowShare = 16;  // length of a row over the length of a window
constexpr std::size_t kStepWindows = 4;
constexpr double kClearChange = 5;        // standard deviations of the mean before the hit, which few samples determine
constexpr std::size_t kMotionBlocks = 8;  // of the samples before a hit
constexpr double kClearMotion = 2;        // standard deviations of a mean of white noise
constexpr double kMaxOff = 0.15;  // largest distance of a window's mean from the fitted step or slope, over its size
// The same of windows that begin later, and of later windows the other way. The ringing and the swing of simulated
// tests without a shift left 0.23 or more and 0.27 or more; steps of a sensor left 0.04 and were never the other way.
constexpr double kMaxOffLater = 0.2;
constexpr double kOtherWay = 0.1, kMaxOtherWay = 0.3;

double mean_level(std::span<const double> x) {
  return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())).mean();
}

double min_change(const RestLevels& levels, double largest) {
  return std::max(kMinBaselineChange * largest,
                  kClearChange * levels.noise / std::sqrt(static_cast<double>(levels.quiet)));
}

using Shifts = std::array<double, kStepWindows>;

Shifts first_shifts(const RestLevels& levels) {
  Shifts shift{};
  for (std::size_t w = 0; w < kStepWindows; ++w) shift[w] = levels.after[w] - *levels.before;
  return shift;
}

// Of a window's shift to the shift of the window before. NaN where all shifts cancel.
double ratio_of(const Shifts& shift) {
  return std::clamp((shift[1] + shift[2] + shift[3]) / (shift[0] + shift[1] + shift[2]), 1e-3, 1.0);
}

// The mean over windows that begin up to `delays` samples later. Needs delays - 1 samples after the window.
double delayed_mean(std::span<const double> x, std::size_t window, std::size_t delays) {
  double mean = mean_level(x.first(window)), sum = 0;
  for (std::size_t d = 0; d < delays; ++d) {
    sum += mean;
    mean += (x[d + window] - x[d]) / static_cast<double>(window);
  }
  return sum / static_cast<double>(delays);
}

std::optional<BaselineChange> find_step(const RestLevels& levels, double largest, double fs_Hz) {
  const Shifts shift = first_shifts(levels);
  if (std::abs(shift[0]) < min_change(levels, largest) || shift[1] * shift[0] <= 0) return std::nullopt;
  const double ratio = ratio_of(shift);  // NaN: then no window is near its expected shift
  for (std::size_t w = 0; w < kStepWindows; ++w) {
    const double expected = shift[0] * std::pow(ratio, static_cast<double>(w));
    if (!(std::abs(shift[w] - expected) <= kMaxOff * std::abs(shift[0]))) return std::nullopt;
  }
  const double window_s = static_cast<double>(levels.window) / fs_Hz;
  const double decay_per_s = -std::log(ratio) / window_s;
  const double exponent = decay_per_s * window_s;
  const double first_mean =
      exponent > 1e-9 ? (1 - std::exp(-exponent)) / exponent : 1;  // of a unit step, over the first window
  const double size = shift[0] / first_mean;
  return BaselineChange{.step = true, .size = size, .share = std::abs(size) / largest, .decay_per_s = decay_per_s};
}

// The line through the level before the hit and the level of the last window. The windows between must lie near it.
std::optional<BaselineChange> find_slope(const RestLevels& levels, std::size_t samples, double largest) {
  const auto middle_of = [&](std::size_t w) {
    return static_cast<double>(levels.first) + (static_cast<double>(w) + 0.5) * static_cast<double>(levels.window);
  };
  const double start = 0.5 * static_cast<double>(levels.quiet);
  const double change = levels.after.back() - *levels.before;
  const double per_sample = change / (middle_of(kRestWindows - 1) - start);
  const double size = per_sample * static_cast<double>(samples);
  if (std::abs(size) < min_change(levels, largest)) return std::nullopt;
  for (std::size_t w = 0; w < kRestWindows; ++w) {
    const double expected = *levels.before + per_sample * (middle_of(w) - start);
    if (std::abs(levels.after[w] - expected) > kMaxOff * std::abs(size)) return std::nullopt;
  }
  return BaselineChange{.step = false, .size = size, .share = std::abs(size) / largest};
}

}  // namespace

RestLevels rest_levels(std::span<const double> x, std::size_t quiet, std::size_t first) {
  RestLevels out{.before = {}, .quiet = quiet, .first = first};
  if (quiet < kMinQuiet || quiet > x.size()) return out;
  out.before = mean_level(x.first(quiet));
  out.noise = rms_about_mean(x.first(quiet));
  const std::size_t window = x.size() / kRowShare;
  if (first + kRestWindows * window > x.size()) return out;
  out.window = window;
  for (std::size_t w = 0; w < kRestWindows; ++w)
    out.after[w] = mean_level(x.subspan(first + w * out.window, out.window));
  return out;
}

std::optional<BaselineChange> find_baseline_change(const RestLevels& levels, std::size_t samples, double largest,
                                                   double fs_Hz) {
  if (!levels.before || levels.window == 0 || !(largest > 0)) return std::nullopt;
  if (auto step = find_step(levels, largest, fs_Hz)) return step;
  return find_slope(levels, samples, largest);
}

bool exceeds_motion_before(const BaselineChange& change, std::span<const double> x, std::size_t quiet) {
  const std::size_t block = std::min(quiet, x.size()) / kMotionBlocks;
  if (block < 2) return true;
  std::array<double, kMotionBlocks> means{};
  for (std::size_t b = 0; b < kMotionBlocks; ++b) means[b] = mean_level(x.subspan(b * block, block));
  double white = 0;  // within the blocks, where slow motion changes little
  for (std::size_t b = 0; b < kMotionBlocks; ++b)
    white += std::pow(rms_about_mean(x.subspan(b * block, block)), 2) / static_cast<double>(kMotionBlocks);
  const double slow = rms_about_mean(means);
  if (slow < kClearMotion * std::sqrt(white / static_cast<double>(block))) return true;
  return std::abs(change.size) > kClearChange * std::max(slow, rms_about_mean(x.last(x.size() / kRowShare)));
}

bool keeps_its_sign(const RestLevels& levels, std::span<const double> x) {
  const Shifts shift = first_shifts(levels);
  double other_way = 0;  // over the first window's shift
  for (std::size_t w = kStepWindows; w < kRestWindows; ++w)
    other_way = std::max(other_way, -(levels.after[w] - *levels.before) / shift[0]);
  if (other_way <= kOtherWay || other_way > kMaxOtherWay) return other_way <= kOtherWay;
  const std::size_t delays = std::max<std::size_t>(levels.window / 4, 1);
  const double ratio = ratio_of(shift);
  double mean_decay = 0;  // of the step, over the delays
  for (std::size_t d = 0; d < delays; ++d)
    mean_decay += std::pow(ratio, static_cast<double>(d) / static_cast<double>(levels.window));
  mean_decay /= static_cast<double>(delays);
  for (std::size_t w = 0; w < kStepWindows; ++w) {
    const double expected = shift[0] * mean_decay * std::pow(ratio, static_cast<double>(w));
    const double later = delayed_mean(x.subspan(levels.first + w * levels.window), levels.window, delays);
    if (std::abs(later - *levels.before - expected) > kMaxOffLater * std::abs(shift[0])) return false;
  }
  return true;
}

double largest_mean(double amplitude, double freq_Hz, double time_s) {
  const double angle = std::numbers::pi * freq_Hz * time_s;
  return amplitude / std::max(angle, 1.0);
}

void subtract_baseline(const BaselineChange& change, std::size_t hit_sample, double fs_Hz, std::span<double> x) {
  for (std::size_t n = change.step ? hit_sample : 0; n < x.size(); ++n) {
    x[n] -= change.size * (change.step ? std::exp(-change.decay_per_s * static_cast<double>(n - hit_sample) / fs_Hz)
                                       : static_cast<double>(n) / static_cast<double>(x.size()));
  }
}

}  // namespace percuss::pipeline
