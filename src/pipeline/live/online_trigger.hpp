#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace percuss::pipeline {

/// A blow seen in the stream of the force.
struct BlowEvent {
  std::uint64_t first = 0;  // frame of the first sample above the threshold
  std::uint64_t peak = 0;   // frame of the largest |force − baseline|
  std::size_t rise = 0;     // frames from 5 % of the peak to the peak
  /// A contact before the largest one: its frame, and its part of the largest force.
  struct Earlier {
    std::uint64_t peak = 0;
    double ratio = 0;
  };
  std::optional<Earlier> earlier{};
};

/// A push of the force that lasts too long for a blow of a hammer, but begins and ends as one does.
struct LongPush {
  std::uint64_t peak = 0;  // frame
  double peak_N = 0;       // signed, baseline removed
  double length_s = 0;     // above 5 % of the peak
};

struct OnlineTriggerOptions {
  double fs_Hz = 0;
  std::optional<double> trigger_N;  // threshold on |force − baseline|; default: from the noise
};

/// Finds the blows that acquire::scan_for_triggers finds in the whole record, as soon as their samples have arrived.
/// The default threshold is 12 standard deviations of the recent noise. After the third blow, it is also at least 1 %
/// of the median peak of the recent blows. The result does not depend on how the samples are divided into calls.
/// theory (1.2)
class OnlineTrigger {
 public:
  OnlineTrigger(const OnlineTriggerOptions& options, std::uint64_t first_frame);

  /// The next samples of the force; `lost`: they are missing, and the values only hold the place.
  void add(std::span<const double> force_N, bool lost = false);
  /// No more samples will come: searches to the end.
  void finish();
  /// The next blow, in order.
  std::optional<BlowEvent> next();
  /// The next long push, in order. Slower changes of the force are drift.
  std::optional<LongPush> next_long_push();

  /// All blows that begin before this frame have been found. It stays at the first sample of an excursion until the
  /// samples that decide whether it is a blow have arrived.
  std::uint64_t searched_to() const { return at_; }

 private:
  double threshold_N() const;
  void step(std::size_t samples);
  void measure_noise(std::size_t samples);
  void measure_drift(const std::vector<double>& medians_N);
  void search();
  std::optional<std::uint64_t> first_above() const;
  std::uint64_t largest_in(std::uint64_t first, std::uint64_t last) const;
  double above_rest_N(std::uint64_t frame) const;
  double distance(std::uint64_t frame) const;
  /// Force minus its rest, which may drift.
  std::vector<double> force_between(std::uint64_t first, std::uint64_t last) const;
  void take_event(std::uint64_t first, std::uint64_t best, std::uint64_t end);
  std::optional<BlowEvent::Earlier> earlier_contact(std::uint64_t first, std::uint64_t peak, std::size_t rise) const;
  void note_long_push(std::uint64_t peak);

  OnlineTriggerOptions options_;
  std::size_t step_;  // frames
  std::uint64_t apart_, own_, reach_, armed_after_;
  std::uint64_t base_;     // frame of force_.front()
  std::uint64_t stepped_;  // frames before it are measured and may be searched
  std::uint64_t at_;       // the search goes on here
  bool waiting_ = false;   // an event begins at at_, and its end has not arrived
  bool finished_ = false;
  std::deque<double> force_;
  struct NoiseStep {
    double median, robust_std, variance;
  };
  std::deque<NoiseStep> steps_;
  std::deque<double> peaks_N_;  // of the recent blows
  std::uint64_t lost_from_ = 0, lost_to_ = 0;
  double baseline_N_ = 0, baseline_at_ = 0;  // the rest of the force at the frame baseline_at_
  double drift_N_ = 0;                       // of the rest, per frame
  double noise_N_ = 0;
  std::uint64_t quiet_until_ = 0;  // a pulse before it must exceed own_level_N_
  double own_level_N_ = 0;
  std::uint64_t measured_ = 0;  // frames
  std::deque<BlowEvent> events_;
  std::deque<LongPush> long_pushes_;
};

}  // namespace percuss::pipeline
