#include "pipeline/live/online_trigger.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "acquire/hits/pulse_shape.hpp"
#include "acquire/hits/trigger_scan.hpp"
#include "core/math/statistics.hpp"

namespace percuss::pipeline {
namespace {

// The noise is measured in steps. A pulse is in few of them, whatever the rate.
constexpr double kStep_s = 0.04, kMinStep = 32, kMaxStep = 512;  // samples; 10 ms at 51.2 kHz
constexpr std::size_t kNoiseSteps = 256;                         // 2.6 s at 51.2 kHz
constexpr double kBaseline_s = 1;
constexpr double kArming_s = 0.25;  // of noise before the first search
constexpr std::size_t kArmingSteps = 8;
constexpr std::uint64_t kFlank = 3;  // times the rise from 5 % of a peak: the peak's own flank
constexpr std::size_t kRecentPeaks = 9, kMinPeaks = 3;

std::uint64_t frames_in(double time_s, double fs_Hz) { return static_cast<std::uint64_t>(time_s * fs_Hz) + 1; }

std::size_t step_samples(double fs_Hz) {
  return std::bit_floor(static_cast<std::size_t>(std::clamp(kStep_s * fs_Hz, kMinStep, kMaxStep)));
}

// The root of the mean of the smaller half.
double root_of_smaller_half(std::vector<double> variances) {
  const std::size_t half = (variances.size() + 1) / 2;
  const auto end = variances.begin() + static_cast<std::ptrdiff_t>(half);
  std::nth_element(variances.begin(), end - 1, variances.end());
  return std::sqrt(std::accumulate(variances.begin(), end, 0.0) / static_cast<double>(half));
}

template <class Item>
std::optional<Item> take_first(std::deque<Item>& queue) {
  if (queue.empty()) return {};
  const Item first = queue.front();
  queue.pop_front();
  return first;
}

}  // namespace

OnlineTrigger::OnlineTrigger(const OnlineTriggerOptions& options, std::uint64_t first_frame)
    : options_(options),
      step_(step_samples(options.fs_Hz)),
      apart_(frames_in(acquire::kTriggerSeparation_s, options.fs_Hz)),
      own_(std::min(apart_, frames_in(acquire::kOwnHit_s, options.fs_Hz))),
      reach_(static_cast<std::uint64_t>(acquire::kLongestPulse_s * options.fs_Hz) + acquire::kLongestPulse_samples),
      armed_after_(std::max<std::uint64_t>(frames_in(kArming_s, options.fs_Hz), kArmingSteps * step_)),
      base_(first_frame),
      stepped_(first_frame),
      at_(first_frame) {}

double OnlineTrigger::above_rest_N(std::uint64_t frame) const {
  return force_[frame - base_] - baseline_N_ - drift_N_ * (static_cast<double>(frame) - baseline_at_);
}

double OnlineTrigger::distance(std::uint64_t frame) const { return std::abs(above_rest_N(frame)); }

double OnlineTrigger::threshold_N() const {
  if (options_.trigger_N) return *options_.trigger_N;
  // The lower median: an accident must not hide the blows that follow.
  double typical_N = 0;
  if (peaks_N_.size() >= kMinPeaks) {
    std::vector<double> peaks_N(peaks_N_.begin(), peaks_N_.end());
    const auto middle = peaks_N.begin() + static_cast<std::ptrdiff_t>((peaks_N.size() - 1) / 2);
    std::nth_element(peaks_N.begin(), middle, peaks_N.end());
    typical_N = *middle;
  }
  return std::max(acquire::kTriggerNoise * noise_N_, acquire::kTriggerFraction * typical_N);
}

void OnlineTrigger::add(std::span<const double> force_N, bool lost) {
  const std::uint64_t end = base_ + force_.size();
  if (lost) {
    if (lost_to_ != end) lost_from_ = end;
    lost_to_ = end + force_N.size();
  }
  force_.insert(force_.end(), force_N.begin(), force_N.end());
  while (base_ + force_.size() - stepped_ >= step_) step(step_);
}

void OnlineTrigger::finish() {
  finished_ = true;
  const std::uint64_t rest = base_ + force_.size() - stepped_;
  if (rest > 0) {
    step(rest);
  } else {
    search();
  }
}

void OnlineTrigger::step(std::size_t samples) {
  measure_noise(samples);
  stepped_ += samples;
  if (finished_ || measured_ >= armed_after_) {
    search();
  } else if (stepped_ - at_ > armed_after_ && lost_to_ > at_) {
    at_ = stepped_ - armed_after_;  // while samples are lost, nothing arms the search, and memory must not grow
  }
  // The search of an event looks back by the length of a pulse.
  const std::uint64_t needed = at_ > reach_ ? at_ - reach_ : 0;
  while (base_ < std::min(needed, stepped_)) {
    force_.pop_front();
    ++base_;
  }
}

void OnlineTrigger::measure_noise(std::size_t samples) {
  const bool lost = lost_from_ < stepped_ + samples && stepped_ < lost_to_;
  if (lost) return;  // constant values would look like silence
  const auto begin = force_.begin() + static_cast<std::ptrdiff_t>(stepped_ - base_);
  std::vector<double> x(begin, begin + static_cast<std::ptrdiff_t>(samples));
  const double deviation = rms_about_mean(x);
  const Spread spread = spread_of(std::move(x));
  steps_.push_back({.median = spread.median, .robust_std = spread.robust_std, .variance = deviation * deviation});
  if (steps_.size() > kNoiseSteps) steps_.pop_front();
  measured_ += samples;
  std::vector<double> recent, robust, variances;
  for (const NoiseStep& one : steps_) {
    robust.push_back(one.robust_std);
    variances.push_back(one.variance);
  }
  // The force may drift: its rest is measured over the last second. An event is taken some time after its peak, so that
  // these steps lie on both sides of it.
  const auto count = std::clamp<std::size_t>(frames_in(kBaseline_s, options_.fs_Hz) / step_, 1, steps_.size());
  for (auto step = steps_.end() - static_cast<std::ptrdiff_t>(count); step != steps_.end(); ++step)
    recent.push_back(step->median);
  measure_drift(recent);
  baseline_N_ = median(std::move(recent));
  baseline_at_ = static_cast<double>(stepped_ + samples) - static_cast<double>(count * step_) / 2;
  // A coarse converter toggles between few values: its robust standard deviation is 0, its standard deviation is not.
  noise_N_ = std::max(median(std::move(robust)), root_of_smaller_half(std::move(variances)));
}

// The drift in N per frame, from the three changes between the quarters of the steps. A drift goes one way for the
// whole second. A push does not, so the smallest of the three changes is free of it.
void OnlineTrigger::measure_drift(const std::vector<double>& medians_N) {
  drift_N_ = 0;
  const std::size_t quarter = medians_N.size() / 4;
  if (quarter == 0) return;
  std::array<double, 4> rest_N{};
  for (std::size_t q = 0; q < rest_N.size(); ++q) {
    const auto begin = medians_N.begin() + static_cast<std::ptrdiff_t>(q * quarter);
    rest_N.at(q) = median({begin, begin + static_cast<std::ptrdiff_t>(quarter)});
  }
  double least_N = std::numeric_limits<double>::infinity();
  for (std::size_t q = 1; q < rest_N.size(); ++q) {
    const double change_N = rest_N.at(q) - rest_N.at(q - 1);
    if (change_N * (rest_N[1] - rest_N[0]) <= 0) return;
    if (std::abs(change_N) < std::abs(least_N)) least_N = change_N;
  }
  drift_N_ = least_N / static_cast<double>(quarter * step_);
}

std::optional<std::uint64_t> OnlineTrigger::first_above() const {
  const double threshold_N = this->threshold_N();
  for (std::uint64_t frame = at_; frame < stepped_; ++frame) {
    const double needed = frame < quiet_until_ ? std::max(own_level_N_, threshold_N) : threshold_N;
    const double here = distance(frame);
    if (here >= needed && here > 0) return frame;
  }
  return {};
}

std::uint64_t OnlineTrigger::largest_in(std::uint64_t first, std::uint64_t last) const {
  std::uint64_t best = first;
  for (std::uint64_t frame = first; frame < last; ++frame) {
    if (distance(frame) > distance(best)) best = frame;
  }
  return best;
}

void OnlineTrigger::search() {
  while (at_ < stepped_) {
    const auto first = waiting_ ? std::optional(at_) : first_above();
    waiting_ = first.has_value();
    at_ = first.value_or(stepped_);
    if (!first) return;
    if (*first + apart_ + reach_ > stepped_ && !finished_) return;
    const std::uint64_t end = std::min(*first + apart_, stepped_);
    std::uint64_t best = largest_in(*first, end);
    // Hits of their own before the largest.
    while (best >= *first + own_) {
      const std::uint64_t before = largest_in(*first, best - own_ + 1);
      if (distance(before) < acquire::kOwnHitFraction * distance(best)) break;
      best = before;
    }
    while (best + 1 < std::min(end + reach_, stepped_) && distance(best + 1) > distance(best)) ++best;  // a cut flank
    take_event(*first, best, end);
  }
}

std::vector<double> OnlineTrigger::force_between(std::uint64_t first, std::uint64_t last) const {
  std::vector<double> x;
  for (std::uint64_t frame = first; frame < last; ++frame) x.push_back(above_rest_N(frame));
  return x;
}

void OnlineTrigger::take_event(std::uint64_t first, std::uint64_t best, std::uint64_t end) {
  const std::uint64_t from = std::max(base_, best > reach_ ? best - reach_ : 0);
  const std::vector<double> x = force_between(from, std::min(best + reach_ + 1, stepped_));
  const double peak_N = x[best - from];
  if (acquire::is_hammer_pulse(x, best - from, noise_N_, options_.fs_Hz)) {
    const std::size_t rise = acquire::rise_samples(acquire::shape_of_pulse(x, best - from));
    events_.push_back({.first = first, .peak = best, .rise = rise, .earlier = earlier_contact(first, best, rise)});
    peaks_N_.push_back(std::abs(peak_N));
    if (peaks_N_.size() > kRecentPeaks) peaks_N_.pop_front();
    own_level_N_ = acquire::kOwnHitFraction * std::abs(peak_N);
    quiet_until_ = std::max(best + apart_, end);
    at_ = std::min(best + own_, quiet_until_);
  } else {  // a drift goes on, and a blow may follow at once
    note_long_push(best);
    quiet_until_ = at_ = std::max(best + 1, end);
  }
  waiting_ = false;
}

std::optional<BlowEvent::Earlier> OnlineTrigger::earlier_contact(std::uint64_t first, std::uint64_t peak,
                                                                 std::size_t rise) const {
  const std::uint64_t guard = kFlank * rise;  // the flank of the largest one
  if (first + guard >= peak) return {};
  const std::uint64_t before = largest_in(first, peak - guard);
  // A contact ends before the next one; a drift stays.
  const double half_N = distance(before) / 2;
  std::uint64_t frame = before;
  while (frame < peak - guard && distance(frame) >= half_N) ++frame;
  if (frame == peak - guard) return {};
  return BlowEvent::Earlier{.peak = before, .ratio = distance(before) / distance(peak)};
}

void OnlineTrigger::note_long_push(std::uint64_t peak) {
  const std::vector<double> x = force_between(base_, stepped_);
  const acquire::PulseShape shape = acquire::shape_of_pulse(x, peak - base_);
  const bool ends = shape.has_rise && shape.fall + 1 < static_cast<double>(x.size());
  const double length_s = (shape.fall - shape.rise) / options_.fs_Hz;
  if (ends && length_s > acquire::kLongestPulse_s)
    long_pushes_.push_back({.peak = peak, .peak_N = x[peak - base_], .length_s = length_s});
}

std::optional<BlowEvent> OnlineTrigger::next() { return take_first(events_); }

std::optional<LongPush> OnlineTrigger::next_long_push() { return take_first(long_pushes_); }

}  // namespace percuss::pipeline
