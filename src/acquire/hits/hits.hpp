#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "acquire/hits/finding.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// One hammer hit: where it is in the record, its pulse, and what is wrong with it.
struct Hit {
  std::size_t row = 0;
  std::size_t first = 0;  // the stretch of the row that belongs to this hit
  std::size_t samples = 0;
  double onset_s = 0;       // where the pulse leaves 5 % of its peak, from the row's beginning (interpolated)
  double peak_N = 0;        // signed, baseline removed
  std::size_t peak = 0;     // its sample in the row
  double pulse_s = 0;       // time above 5 % of the peak
  double bandwidth_Hz = 0;  // where the force spectrum has fallen 20 dB below its largest line
  double noise_N = 0;       // deviation of the force channel's noise
  double baseline_N = 0;
  std::size_t gate_first = 0;     // first sample of `gated_N` in the row
  std::vector<double> gated_N;    // the pulse with the anti-alias filter's ringing, baseline removed; zero outside
  std::vector<double> ungated_N;  // the whole stretch, baseline removed; empty unless HitOptions::gate_force is off
  std::vector<Finding> findings;
};

struct HitOptions {
  std::optional<double> trigger_N;
  std::optional<double> pretrigger_s;  // default: 128 samples or 5 ms, whichever is longer
  std::optional<double> length_s;      // of the stretch, pre-trigger included
  double from_s = 0;                   // only hits in this part of each row
  std::optional<double> to_s;
  bool gate_force = true;  // false: the FRFs take the force's whole stretch, noise and all
};

/// Finds and grades the hits of a record from its force alone. In a record of several rows each row is one hit; a
/// single row or `Record::continuous` is searched. A row without a pulse yields a hit with `no_pulse`. Findings set
/// here: double_hit, overload (force), late_trigger, no_pulse, weak, polarity. errors  InputError when the part asked
/// for by from_s/to_s is empty.
std::vector<Hit> find_hits(const Record& record, const HitOptions& options = {});

/// Adds `low_bandwidth` where the force's −20 dB frequency is below the band's upper end.
void grade_bandwidth(std::vector<Hit>& hits, double band_high_Hz);

}  // namespace percuss::acquire
