#include "acquire/hits/finding.hpp"

#include <algorithm>

namespace percuss::acquire {

const char* name_of(FindingCode code) {
  switch (code) {
    case FindingCode::double_hit:
      return "double_hit";
    case FindingCode::overload:
      return "overload";
    case FindingCode::late_trigger:
      return "late_trigger";
    case FindingCode::no_pulse:
      return "no_pulse";
    case FindingCode::weak:
      return "weak";
    case FindingCode::truncated_decay:
      return "truncated_decay";
    case FindingCode::low_bandwidth:
      return "low_bandwidth";
    case FindingCode::low_coherence:
      return "low_coherence";
    case FindingCode::outlier:
      return "outlier";
    case FindingCode::polarity:
      return "polarity";
    case FindingCode::force_clipped:
      return "force_clipped";
    case FindingCode::rejected_live:
      return "rejected_live";
    case FindingCode::lost_samples:
      return "lost_samples";
  }
  return "";
}

bool has_finding(const std::vector<Finding>& findings, FindingCode code) {
  return std::any_of(findings.begin(), findings.end(), [&](const Finding& finding) { return finding.code == code; });
}

bool rejects(const std::vector<Finding>& findings) {
  return std::any_of(findings.begin(), findings.end(), [](const Finding& f) { return f.severity == Severity::reject; });
}

}  // namespace percuss::acquire
