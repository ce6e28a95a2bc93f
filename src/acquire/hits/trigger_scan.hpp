#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

// Standard deviations: one false alarm in 10^30 samples of Gaussian noise, if the standard deviation is 4 % too small.
inline constexpr double kTriggerNoise = 12;
inline constexpr double kTriggerFraction = 0.01;  // of the largest: a smaller hit is useless
inline constexpr double kTriggerSeparation_s = 0.25;
// A hammer bounces back within some tens of milliseconds, and with less force. A pulse at least kOwnHit_s from the
// largest pulse and at least kOwnHitFraction of it is a separate hit.
inline constexpr double kOwnHit_s = 0.1;
inline constexpr double kOwnHitFraction = 0.5;

/// The force pulses of one row.
struct TriggerScan {
  double baseline_N = 0;                           // median over the row
  double noise_N = 0;                              // robust standard deviation about it
  double largest_N = 0;                            // largest |force − baseline|
  std::size_t largest_first = 0, largest_end = 0;  // range of samples that contains it
  double trigger_N = 0;                            // the threshold used
  std::vector<std::size_t> events;  // sample of the largest |force − baseline| of each event, ascending
};

struct TriggerOptions {
  std::optional<double> trigger_N;             // threshold on |force − baseline|; default: from the noise
  double separation_s = kTriggerSeparation_s;  // weaker pulses within this time belong to one event
  std::size_t first = 0;                       // samples to search, [first, last)
  std::size_t last = static_cast<std::size_t>(-1);
};

/// Searches one row of the record for pulses of either sign. Reads the row in chunks, then up to 64 samples of each
/// event again. Needs memory for about 1/16 of the row from 6.4 kHz on, and up to 1/2 of it below 1.6 kHz. The default
/// threshold is max(12 standard deviations of the noise, 1 % of the largest). An event begins with the first sample
/// above the threshold. Its largest sample is within `separation_s` of the first. The event ends `separation_s` after
/// the largest sample. A pulse at least 0.1 s from the largest and at least half its size is an event of its own.
/// theory (1.2)
TriggerScan scan_for_triggers(const Record& record, std::size_t row, const TriggerOptions& options = {});

}  // namespace percuss::acquire
