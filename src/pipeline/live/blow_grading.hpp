#pragma once
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "acquire/record/row_mark.hpp"
#include "pipeline/analysis_options.hpp"
#include "pipeline/live/blow_samples.hpp"
#include "pipeline/live/live_channels.hpp"
#include "pipeline/live/row_store.hpp"

namespace percuss::pipeline {

/// Of the median of the accepted blows: a smaller blow is weak, as for acquire::find_hits.
inline constexpr double kWeakBlow = 0.2;

/// What is known of a blow before its analysis.
struct BlowCircumstances {
  /// The rms of the strongest sinusoid in a response before the blow, and the least such rms before any blow so far:
  /// its noise.
  struct Rest {
    double before_mps2 = 0, noise_mps2 = std::numeric_limits<double>::infinity();
  };
  bool lost_samples = false;
  bool row_ended = false;                   // of a replayed record
  bool recording_ended = false;             // within the samples of the blow
  std::optional<std::size_t> no_numbers{};  // the first signal with samples that are no numbers: 0 for the force
  bool struck_again = false;                // the next blow begins within its samples
  bool during_previous = false;             // it begins within the samples of the blow before
  double contact_before = 0;                // a contact before the samples, as part of the peak; 0: none
  double contact_before_s = 0;              // its time before the peak
  std::vector<double> range;  // [1 + channels], largest |value| over the device's full scale; empty: not known
  double typical_peak_N = 0;  // median of the accepted blows; 0: too few
  double typical_bandwidth_Hz = 0;
  std::size_t pretrigger = 0;  // samples
  std::vector<Rest> rest{};    // [responses]
  bool none_accepted = false;  // up to now
  bool all_rejected = false;   // there were blows, and none is accepted
  bool length_stated = false;  // by the user, not by the decay of the first blow
  double clipped_at_N = 0;     // the force at which blows were clipped before; 0: none was, or at different ones
};

/// The verdict on a blow. Accepted: no mark.
struct BlowGrade {
  acquire::RowMark mark = acquire::RowMark::none;
  std::string reason{};  // what is wrong: "two contacts, the second 31 % of the first and 12 ms later"
  std::string remedy{};  // what to do: "strike shorter: let the hammer bounce off"
  double peak_N = 0, pulse_s = 0, bandwidth_Hz = 0;
  std::optional<double> force_range{}, accel_range{};  // part of full scale
  std::size_t accel_channel = 0;                       // that has accel_range
  bool rings_at_end = false;                           // the window is too short
  bool moved_before = false;                           // a little: the structure had not come to rest
  std::string implausible{};                           // what no hammer test has: a sensitivity is wrong
  bool unlike_others = false;                          // the other blows explain little of it: low_coherence
  std::optional<bool> blows_differ{};                  // whether any accepted blow is so; nothing: not compared
  /// Accepted rows that do not count any longer, now that there is this blow to compare with: at the same point, an
  /// outlier or a force that was clipped at the same level; at any point, a weak blow (Guide::regrade_weak).
  struct Regraded {
    std::size_t row = 0;
    acquire::RowMark mark = acquire::RowMark::outlier;
  };
  std::vector<Regraded> regraded{};

  bool accepted() const { return mark == acquire::RowMark::none; }
};

/// The accepted blows at the point, in a store, and the analysis's options.
struct BlowContext {
  const LiveChannels& channels;
  std::shared_ptr<const RowStore> store;
  std::vector<std::size_t> rows;  // in the store
  const AnalysisOptions& options;
};

/// Grades a blow with the findings of the analysis (acquire/hits, pipeline/hits) on the blows of its point, and with
/// what is known only during the recording: range, lost samples, silence, the next blow. The first reason counts, in
/// order of what the operator must mend first.
BlowGrade grade_blow(const BlowSamples& samples, const BlowCircumstances& circumstances, const BlowContext& context);

}  // namespace percuss::pipeline
