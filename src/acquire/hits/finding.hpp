#pragma once
#include <optional>
#include <string>
#include <vector>

namespace percuss::acquire {

enum class FindingCode {
  double_hit,
  overload,
  late_trigger,
  no_pulse,
  weak,
  truncated_decay,
  low_bandwidth,
  low_coherence,
  outlier,
  polarity
};
enum class Severity { info, warn, reject };

/// One judgement on a hit, with the number that decided it.
struct Finding {
  FindingCode code;
  Severity severity;
  double value = 0;
  std::string message;            // one sentence, with units
  std::optional<double> delay_s;  // double_hit: from the first pulse to the other
};

/// The code's name in JSON: "double_hit", …
const char* name_of(FindingCode code);
const char* name_of(Severity severity);

/// True when a finding of Severity::reject is among them.
bool rejects(const std::vector<Finding>& findings);

}  // namespace percuss::acquire
