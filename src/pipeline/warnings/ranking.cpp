#include "pipeline/warnings/ranking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace percuss::pipeline {
namespace {

using acquire::Severity;

struct RankedCode {
  std::string_view code;
  Severity severity;
};

// Most serious first: wrong quantities and mixed tests, then distorted signals, structures that are not linear or not
// at rest, what the fit leaves open, and remarks.
constexpr auto kRanking = std::to_array<RankedCode>({
    {"files_disagree", Severity::warn},
    {"hits_disagree", Severity::reject},
    {"units_differ", Severity::reject},
    {"reversed", Severity::reject},
    {"clock_mismatch", Severity::reject},
    {"polarity", Severity::reject},
    {"dead_channel", Severity::reject},
    {"lost_samples", Severity::reject},
    {"already_windowed", Severity::reject},
    {"force_clipped", Severity::reject},
    {"response_clipped", Severity::reject},
    {"dropout", Severity::reject},
    {"duplicate", Severity::warn},
    {"skew", Severity::warn},
    {"rattle", Severity::warn},
    {"drifting", Severity::warn},
    {"moving", Severity::warn},
    {"moving_modes", Severity::warn},
    {"nonlinear", Severity::warn},
    {"mass_loading", Severity::warn},
    {"not_at_rest", Severity::warn},
    {"outlier", Severity::warn},
    {"low_coherence", Severity::warn},
    {"overload", Severity::warn},
    {"double_hit", Severity::warn},
    {"no_pulse", Severity::warn},
    {"late_trigger", Severity::warn},
    {"coarse_steps", Severity::warn},
    {"hum", Severity::warn},
    {"tone", Severity::warn},
    {"driving_point_sign", Severity::warn},
    {"reciprocity", Severity::warn},
    {"frac", Severity::warn},
    {"unclaimed_peaks", Severity::warn},
    {"double_peak", Severity::warn},
    {"sensor_on_node", Severity::warn},
    {"assumed_tube", Severity::warn},
    {"short_pretrigger", Severity::warn},
    {"low_bandwidth", Severity::warn},
    {"weak", Severity::warn},
    {"force_noise_unknown", Severity::warn},
    {"not_told", Severity::warn},
    {"drift", Severity::warn},
    {"no_rest", Severity::warn},
    {"missing_position", Severity::warn},
    {"few_points", Severity::warn},
    {"input", Severity::warn},
    {"not_a_tube", Severity::info},
    {"rejected_hits", Severity::info},
    {"truncated_decay", Severity::info},
    {"no_geometry", Severity::info},
});

const RankedCode* find_code(std::string_view code) {
  const auto* const it =
      std::find_if(kRanking.begin(), kRanking.end(), [&](const RankedCode& known) { return known.code == code; });
  return it == kRanking.end() ? nullptr : it;
}

int order_of(Severity severity) { return severity == Severity::reject ? 0 : severity == Severity::warn ? 1 : 2; }

// The hits that share one finding.
struct SharedFinding {
  std::vector<std::size_t> used, rejected;
  const acquire::Finding* first = nullptr;  // among the hits that are used, if any is
};

std::string hit_list(const std::vector<std::size_t>& hits) {
  constexpr std::size_t kMaxListed = 8;
  std::string list = hits.size() == 1 ? "hit " : "hits ";
  for (std::size_t i = 0; i < std::min(hits.size(), kMaxListed); ++i)
    list += fmt::format("{}{}", i > 0 ? ", " : "", hits[i]);
  if (hits.size() > kMaxListed) list += fmt::format(" and {} more", hits.size() - kMaxListed);
  return list;
}

Warning statement_of(const SharedFinding& shared) {
  const bool used = !shared.used.empty();
  std::string who = used ? hit_list(shared.used) : hit_list(shared.rejected) + " (not used)";
  if (used && !shared.rejected.empty()) who += " and " + hit_list(shared.rejected) + " (not used)";
  const std::size_t count = shared.used.size() + shared.rejected.size();
  return {.code = name_of(shared.first->code),
          .message = fmt::format("{}: {}{}", who, shared.first->message, count > 1 ? " (the first of them)" : ""),
          .options = shared.first->options,
          .severity = used ? shared.first->severity : Severity::info};
}

}  // namespace

Severity severity_of(std::string_view code) {
  const RankedCode* known = find_code(code);
  return known != nullptr ? known->severity : Severity::warn;
}

std::vector<Warning> ranked(std::vector<Warning> warnings) {
  for (Warning& warning : warnings) {
    if (!warning.severity) warning.severity = severity_of(warning.code);
  }
  const auto key = [](const Warning& warning) {
    const RankedCode* known = find_code(warning.code);
    return std::pair(order_of(*warning.severity),
                     known != nullptr ? static_cast<std::size_t>(known - kRanking.data()) : kRanking.size());
  };
  std::stable_sort(warnings.begin(), warnings.end(),
                   [&](const Warning& a, const Warning& b) { return key(a) < key(b); });
  return warnings;
}

std::vector<Warning> trust_statements(const std::vector<Warning>& warnings, const std::vector<AnalysedHit>& hits) {
  std::map<acquire::FindingCode, SharedFinding> findings;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    for (const acquire::Finding& finding : hits[h].hit.findings) {
      SharedFinding& shared = findings[finding.code];
      if (shared.first == nullptr || (hits[h].accepted && shared.used.empty())) shared.first = &finding;
      auto& list = hits[h].accepted ? shared.used : shared.rejected;
      if (list.empty() || list.back() != h) list.push_back(h);
    }
  }
  std::vector<Warning> out = warnings;
  for (const auto& [code, shared] : findings) {
    // A warning with the code of a finding summarises it.
    const auto same = [name = name_of(code)](const Warning& warning) { return warning.code == name; };
    if (std::none_of(warnings.begin(), warnings.end(), same)) out.push_back(statement_of(shared));
  }
  return ranked(std::move(out));
}

}  // namespace percuss::pipeline
