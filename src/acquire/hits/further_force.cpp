#include "acquire/hits/further_force.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "acquire/hits/clipping.hpp"
#include "acquire/hits/smoothed_pulse.hpp"
#include "core/math/statistics.hpp"

namespace percuss::acquire {
namespace {

constexpr double kNoise = 6;            // standard deviations of the smoothed force
constexpr double kMinFraction = 0.001;  // of the peak: smaller contacts change an FRF by less than 0.01 dB
constexpr double kSteps = 1.5;          // of the recorder's resolution: a coarse one rounds slow noise up by a step
constexpr std::size_t kMinGuard = 8;    // samples beside the pulse that belong to it
constexpr double kMaxPause = 1.5;       // pulse lengths; after a longer pause the force is a contact of its own
constexpr std::size_t kMaxPull = 3;     // times the longest pause; a longer pull between pushes is no ringing
constexpr double kTailFraction = 0.1;   // of the peak: a larger push in the tail is a contact
constexpr double kStandsOut = 5;        // times the tail before it: such a push is a contact, too
constexpr std::size_t kTailBefore = 2;  // pulse lengths before a push in which the tail is measured
constexpr double kTwoSigned = 0.5;      // pull over push; a push beside a deeper pull is ringing
constexpr double kRingingReach = 2;     // pulse lengths around a push in which ringing pulls
constexpr double kPushOverDip = 1.5;    // times the deepest dip; a smaller push is noise
constexpr double kSoft = 3;             // times the length of the main pulse: softer than a contact of this hammer
constexpr double kSpikeNoise = 10;      // standard deviations at which the length of a push can be measured
constexpr double kGateReach = 1.25;     // pulse lengths on either side of a contact's peak
constexpr std::size_t kSpreadSamples = 1024;

// The largest |force| at least `guard` samples outside the crossings of the pulse.
double largest_outside(std::span<const double> x, const PulseShape& pulse, double guard) {
  const auto before = static_cast<std::size_t>(std::max(0.0, pulse.rise - guard));
  const auto after = std::min(x.size(), static_cast<std::size_t>(pulse.fall + guard));
  return std::max(extremes_of(x.first(before)).max_distance_from(0),
                  extremes_of(x.subspan(after)).max_distance_from(0));
}

class ForceSearch {
 public:
  ForceSearch(std::span<const double> force_N, const PulseShape& pulse, double noise_N)
      : force_(force_N),
        pulse_(pulse),
        noise_N_(noise_N),
        sign_(force_N[pulse.peak] < 0 ? -1 : 1),
        width_(std::max(1.0, pulse.fall - pulse.rise)),
        guard_(std::max(width_, static_cast<double>(kMinGuard))),
        half_(static_cast<std::size_t>(width_ / 4)) {}

  // Whether no force beside the pulse can exceed the noise.
  bool quiet() const {
    return largest_outside(force_, pulse_, guard_) <
           std::max(kNoise * white_noise_N(), kMinFraction * std::abs(force_[pulse_.peak]) / 2);
  }

  FurtherForce find(const Gate& pulse_gate, std::size_t max_tail) {
    smooth();
    if (is_noise(pulse_gate.end)) return {.end = pulse_gate.end, .contacts = {}};
    set_threshold();
    const auto guarded = static_cast<std::size_t>(pulse_.fall + guard_);
    last_tail_ = std::min(force_.size(), pulse_gate.end + max_tail);
    FurtherForce out{.end = end_of_activity(pulse_gate.end), .contacts = {}};
    if (pulse_.rise > guard_) scan(out, 0, static_cast<std::size_t>(pulse_.rise - guard_), false);
    scan(out, std::min(guarded, force_.size()), force_.size(), true);
    if (out.end >= last_tail_ && last_tail_ < force_.size()) out.end = pulse_gate.end;
    remove_noise(out);
    std::sort(out.contacts.begin(), out.contacts.end(),
              [](const SecondPulse& a, const SecondPulse& b) { return a.delay_samples < b.delay_samples; });
    return out;
  }

 private:
  void smooth() {
    x_ = smoothed(force_, sign_, half_);
    const auto rise = static_cast<std::size_t>(std::max(0.0, pulse_.rise));
    const std::size_t fall = std::min(x_.size(), static_cast<std::size_t>(pulse_.fall) + 1);
    const auto top = std::max_element(x_.begin() + static_cast<std::ptrdiff_t>(rise),
                                      x_.begin() + static_cast<std::ptrdiff_t>(fall));
    main_ = *top;
    const auto [first, end] = above(x_, 1, static_cast<std::size_t>(top - x_.begin()), main_ / 2);
    length_ = static_cast<double>(end - first);
  }

  double white_noise_N() const { return noise_N_ / std::sqrt(static_cast<double>(2 * half_ + 1)); }

  // Whether there is nothing to find: outside the pulse, no smoothed force exceeds the least threshold, and after the
  // pulse, no sample of the force exceeds the noise.
  bool is_noise(std::size_t pulse_end) const {
    const double least = std::max(kNoise * white_noise_N(), kMinFraction * main_);
    const auto before = static_cast<std::size_t>(std::max(0.0, pulse_.rise - guard_));
    const std::size_t after = std::min({pulse_end, static_cast<std::size_t>(pulse_.fall + guard_), x_.size()});
    const std::span<const double> all(x_);
    return extremes_of(all.first(before)).max_distance_from(0) < least &&
           extremes_of(all.subspan(after)).max_distance_from(0) < least &&
           extremes_of(force_.subspan(after)).max_distance_from(0) < std::max(kNoise * noise_N_, least);
  }

  void set_threshold() {
    // Hum and slow noise remain in the mean over a few samples, so the noise is measured there.
    const double white = white_noise_N();
    const double measured = spread_of(subsampled(x_, kSpreadSamples)).robust_std;
    threshold_ = std::max({kNoise * std::max(white, measured), kMinFraction * main_, kSteps * resolution_of(force_)});
  }

  // The end of the force that continues from `end` without a pause. A pull is no pause, because ringing pulls between
  // its pushes. But a pull longer than kMaxPull pauses is the undershoot of an AC-coupled channel.
  std::size_t end_of_activity(std::size_t end) const {
    const auto pause = static_cast<std::size_t>(std::max(kMaxPause * width_, static_cast<double>(kMinGuard)));
    const double single = std::max(kNoise * noise_N_, threshold_);
    std::size_t active = end;
    for (std::size_t i = end; i < last_tail_ && i - active <= pause && i - end <= kMaxPull * pause; ++i) {
      if (x_[i] < -threshold_) active = i + 1;
      if (x_[i] > threshold_ || sign_ * force_[i] > single) active = end = i + 1;
    }
    return end;
  }

  // Finds the pushes that rise from a valley and fall to half.
  void scan(FurtherForce& out, std::size_t begin, std::size_t end, bool forward) const {
    double valley = std::numeric_limits<double>::infinity(), floor = 0;
    std::size_t top = 0;
    bool rising = false;
    for (std::size_t n = 0; n + begin < end; ++n) {
      const std::size_t i = forward ? begin + n : end - 1 - n;
      if (rising && x_[i] < floor + (x_[top] - floor) / 2) {
        classify_push(out, top, floor);
        rising = false;
        valley = x_[i];
      }
      valley = std::min(valley, x_[i]);
      if (rising) {
        if (x_[i] > x_[top]) top = i;
        continue;
      }
      const double rise = x_[i] - std::max(valley, 0.0);
      if (rise < threshold_ || rise < 0.5 * x_[i]) continue;
      floor = std::max(valley, 0.0);
      top = i;
      rising = true;
    }
    if (rising) classify_push(out, top, floor);
  }

  void classify_push(FurtherForce& out, std::size_t top, double floor) const {
    const double rise = x_[top] - floor;
    if (pulls_beside(top, rise)) return;
    const auto [first, end] = above(x_, 1, top, x_[top] - rise / 2);
    const auto length = static_cast<double>(end - first);
    if (length > kSoft * length_ + 2) {
      extend_by_tail(out, first, end);
    } else if (top >= out.end || top < pulse_.peak || rise > kTailFraction * main_ ||
               rise > kStandsOut * tail_force_before(first)) {
      out.contacts.push_back(contact(top, rise));
    }
  }

  // The largest force of the tail just before a push that begins at `first`: within kTailBefore pulse lengths, and
  // after the pulse.
  double tail_force_before(std::size_t first) const {
    const auto guard = static_cast<std::size_t>(guard_);
    const std::size_t end = first - std::min(first, guard / 2);
    const std::size_t begin =
        std::max(static_cast<std::size_t>(pulse_.fall) + guard / 2, end - std::min(end, kTailBefore * guard));
    if (begin >= end) return main_;
    return extremes_of(std::span(x_).subspan(begin, end - begin)).max_distance_from(0);
  }

  bool pulls_beside(std::size_t top, double rise) const {
    const auto reach = static_cast<std::size_t>(kRingingReach * guard_);
    const std::size_t first = top > reach ? top - reach : 0, end = std::min(top + reach + 1, x_.size());
    const auto lowest = std::min_element(x_.begin() + static_cast<std::ptrdiff_t>(first),
                                         x_.begin() + static_cast<std::ptrdiff_t>(end));
    return -*lowest > kTwoSigned * rise;
  }

  // Slow noise rises and falls over times longer than a contact, and dips as often as it pushes.
  void remove_noise(FurtherForce& out) const {
    const auto reach = static_cast<std::size_t>(kSoft * length_);
    const double least = std::max(threshold_, kPushOverDip * largest_dip(out.end));
    std::erase_if(out.contacts, [&](const SecondPulse& contact) {
      const auto at = static_cast<std::size_t>(static_cast<double>(pulse_.peak) + contact.delay_samples);
      const bool beside_pulse = at + reach + 1 > static_cast<std::size_t>(pulse_.rise) && at < out.end + reach;
      if (beside_pulse || at < reach || at + reach >= x_.size()) return false;
      return x_[at] - std::max(x_[at - reach], x_[at + reach]) < least;
    });
  }

  // The deepest dip as short as a contact, beside the pulse and its tail. A hammer only pushes: a dip is noise.
  double largest_dip(std::size_t tail_end) const {
    const auto reach = static_cast<std::size_t>(kSoft * length_);
    const auto before = static_cast<std::size_t>(std::max(0.0, pulse_.rise - guard_));
    double deepest = 0;
    for (std::size_t i = reach; i + reach < x_.size(); ++i) {
      if (i + reach >= before && i < tail_end + reach) continue;
      deepest = std::max(deepest, std::min(x_[i - reach], x_[i + reach]) - x_[i]);
    }
    return deepest;
  }

  // A soft push that begins soon after the pulse, compared with its own length, is the pulse's tail.
  void extend_by_tail(FurtherForce& out, std::size_t first, std::size_t end) const {
    const std::size_t length = end - first;
    if (first < pulse_.peak || first > out.end + length || end > last_tail_) return;
    while (end < last_tail_ && x_[end] > threshold_) ++end;
    out.end = std::max(out.end, end_of_activity(end));
  }

  SecondPulse contact(std::size_t top, double rise) const {
    // The delay is between the peaks of the force, not of the smoothed force.
    const std::size_t reach = 2 * half_ + 1;
    const std::size_t begin = top > reach ? top - reach : 0, end = std::min(top + reach + 1, force_.size());
    std::size_t peak = begin;
    for (std::size_t i = begin; i < end; ++i) {
      if (sign_ * force_[i] > sign_ * force_[peak]) peak = i;
    }
    return {.delay_samples = static_cast<double>(peak) - static_cast<double>(pulse_.peak),
            .ratio = rise / main_,
            .spike = is_spike(peak),
            .gate = gate_of(peak)};
  }

  bool is_spike(std::size_t peak) const {
    const double height = std::abs(force_[peak]);
    if (height < kSpikeNoise * noise_N_) return false;
    return width_at_half_peak(force_, sign_, peak) < kMaxSpikeLength * width_at_half_peak(force_, sign_, pulse_.peak);
  }

  Gate gate_of(std::size_t peak) const {
    const auto reach = static_cast<std::size_t>(kGateReach * guard_);
    const Gate gate = gate_around(force_, shape_of_pulse(force_, peak), noise_N_);
    return {.first = std::min(gate.first, peak > reach ? peak - reach : 0),
            .end = std::min(std::max(gate.end, peak + reach + 1), force_.size())};
  }

  std::span<const double> force_;
  PulseShape pulse_;
  double noise_N_, sign_, width_, guard_;
  std::size_t half_, last_tail_ = 0;
  std::vector<double> x_;  // smoothed, positive at the main pulse
  double main_ = 0, length_ = 0, threshold_ = 0;
};

}  // namespace

FurtherForce further_force(std::span<const double> force_N, const PulseShape& pulse, const Gate& pulse_gate,
                           double noise_N, const FurtherForceOptions& options) {
  ForceSearch search(force_N, pulse, noise_N);
  if (search.quiet()) return {.end = pulse_gate.end, .contacts = {}};
  return search.find(pulse_gate, options.max_tail);
}

}  // namespace percuss::acquire
