#pragma once
/// Hammer hits: found in the force, graded, each with its findings.
///
/// @code
/// #include <iostream>
/// #include <percuss/hits.hpp>
/// #include <percuss/synth.hpp>
///
/// int main() {
///   const percuss::Record record = percuss::synthesise_preset("double-hit").record;
///   for (const percuss::Hit& hit : percuss::find_hits(record)) {
///     const char* const verdict = hit.accepted ? "accepted" : "rejected";
///     std::cout << "hit " << hit.index + 1 << ": " << hit.peak_force_N << " N, " << verdict << '\n';
///     for (const percuss::Finding& finding : hit.findings) std::cout << "   " << finding.message << '\n';
///   }
/// }
/// @endcode
#include <percuss/record.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace percuss {

enum class Severity { info, warn, reject };

/// One judgement on a hit, with the number that decided it.
struct Finding {
  std::string code;  // "double_hit", "overload", "late_trigger", …; docs/schema/analysis.schema.json lists them
  Severity severity = Severity::info;
  double value = 0;
  std::string message;
  std::vector<OptionId> options{};  // that the message concerns
  std::optional<double> delay_s{};  // double_hit: from the first pulse to the second; lost_samples: from the blow
};

struct Hit {
  std::size_t index = 0;  // the number that accept_hit and reject_hit take
  std::size_t row = 0;
  int point = 0;
  double onset_s = 0;       // the force first exceeds 5 % of its peak, from the row's beginning
  double peak_force_N = 0;  // signed
  double pulse_s = 0;       // time above 5 % of the peak
  double bandwidth_Hz = 0;  // the force spectrum has fallen 20 dB below its largest line
  bool accepted = false;
  bool by_user = false;  // accept_hit or reject_hit decided
  std::vector<Finding> findings;
};

struct HitOptions {
  std::optional<double> trigger_N{};     // default: from the noise
  std::optional<double> pretrigger_s{};  // default: the longest of 128 samples, 5 ms and twice the pulse's rise
  std::optional<double> length_s{};      // of the samples of a hit, pre-trigger included; default: to the next hit
  double from_s = 0;                     // find only hits after this time of each row
  std::optional<double> to_s{};          // find only hits before this time
  bool force_window = true;              // the pulse alone enters the FRF; false: the whole force record
  std::vector<std::size_t> accept_hit{}, reject_hit{};  // overrule the findings
};

/// Hits graded by their force; no acceleration is read. Analysis::hits() grades the responses too.
/// errors  InputError: no such hit in accept_hit or reject_hit, an empty time range, a time below 0, several runs (see
///         Record::runs).
std::vector<Hit> find_hits(const Record& record, const HitOptions& options = {});

}  // namespace percuss
