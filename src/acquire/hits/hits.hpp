#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "acquire/hits/finding.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// A hammer hit: its position in the record, its pulse and its findings.
struct Hit {
  std::size_t row = 0;
  std::size_t first = 0;  // first sample of the hit in its row
  std::size_t samples = 0;
  double onset_s = 0;       // the force first exceeds 5 % of its peak, from the start of the row (interpolated)
  double peak_N = 0;        // signed, baseline removed
  std::size_t peak = 0;     // its sample in the row
  double pulse_s = 0;       // time above 5 % of the peak
  double bandwidth_Hz = 0;  // the force spectrum has fallen 20 dB below its largest line
  double noise_N = 0;       // standard deviation of the noise of the force channel
  double baseline_N = 0;
  double coupling_Hz = 0;      // corner of the force channel's AC coupling, where the force shows it
  std::size_t gate_first = 0;  // first sample of `gated_N` in the row
  std::size_t pulse_end = 0;   // end of the pulse with the anti-alias filter's ringing, a sample of the row
  std::size_t tail_end = 0;    // end of the hammer's ringing or of the contact's tail; at least pulse_end
  // The pulse, its tail, and further contacts, baseline removed; zero between them and outside.
  std::vector<double> gated_N;
  std::vector<double> ungated_N;  // all samples, baseline removed; empty unless HitOptions::gate_force is off
  std::vector<Finding> findings;
};

struct HitOptions {
  std::optional<double> trigger_N;
  std::optional<double> pretrigger_s;  // default: the longest of 128 samples, 5 ms and twice the rise of the pulse
  std::optional<double> length_s;      // of the samples of a hit, with the pre-trigger
  double from_s = 0;                   // search only from here to `to_s` in each row
  std::optional<double> to_s;
  bool gate_force = true;  // false: FRFs use the force of all samples, with its noise
};

/// Finds and grades the hits of a record from its force. In a record of several rows, each row is one hit. A single
/// row, or a record with `Record::continuous`, is searched for pulses. A row without a pulse yields a hit with
/// `no_pulse`.
/// Findings added: double_hit, overload (force), force_clipped, late_trigger, no_pulse, weak, polarity, rejected_live.
/// errors  InputError: no samples between from_s and to_s; fewer than two samples in length_s
std::vector<Hit> find_hits(const Record& record, const HitOptions& options = {});

/// Adds `low_bandwidth` to hits whose −20 dB frequency is below the upper end of the band.
void grade_bandwidth(std::vector<Hit>& hits, double band_high_Hz);

}  // namespace percuss::acquire
