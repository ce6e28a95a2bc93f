#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/warning.hpp"

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
  polarity,
  force_clipped,
  rejected_live,
  lost_samples
};
using warnings::Severity;

/// A judgement on a hit, and the number that decided it.
struct Finding {
  FindingCode code;
  Severity severity;
  double value = 0;
  std::string message;              // one sentence, with units
  std::vector<OptionId> options{};  // that the message concerns
  // double_hit: from the first pulse to the second. lost_samples: from the blow to the missing samples after it;
  // nothing if they lie within the pulse or beside it.
  std::optional<double> delay_s{};
  bool before_main = false;  // double_hit: the smaller pulse came first
};

/// The code's name in JSON: "double_hit", …
const char* name_of(FindingCode code);

/// Whether one of the findings has this code.
bool has_finding(const std::vector<Finding>& findings, FindingCode code);

/// Whether one of the findings has Severity::reject.
bool rejects(const std::vector<Finding>& findings);

}  // namespace percuss::acquire
