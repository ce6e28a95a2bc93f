#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Where a row's force rises out of its noise.
struct TriggerScan {
  double baseline_N = 0;                           // median over the row
  double noise_N = 0;                              // robust standard deviation about it
  double largest_N = 0;                            // largest |force − baseline| …
  std::size_t largest_first = 0, largest_end = 0;  // … and the samples it is among
  double trigger_N = 0;                            // the threshold used
  std::vector<std::size_t> events;  // sample of the largest |force − baseline| of each stretch above it, ascending
};

struct TriggerOptions {
  std::optional<double> trigger_N;  // threshold on |force − baseline|; default: from the row's own noise
  double separation_s = 0.25;       // later stretches within this belong to the same event
  std::size_t first = 0;            // the part of the row to search
  std::size_t last = static_cast<std::size_t>(-1);
};

/// Searches one row of the record for pulses of either sign, reading it once, in chunks: memory is 1/64 of the row.
/// The threshold is max(12 noise deviations, 1 % of the largest) unless given. An event is the largest sample within
/// `separation_s` of the first one above the threshold.
/// theory (1.2)
TriggerScan scan_for_triggers(const Record& record, std::size_t row, const TriggerOptions& options = {});

}  // namespace percuss::acquire
