#include "pipeline/warnings/ranking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "pipeline/warnings/hit_list.hpp"

namespace percuss::pipeline {
namespace {

using warnings::Severity;

// Most serious first within each severity: wrong quantities and mixed tests; distorted or incomplete signals of the
// whole test; structures that are not linear or not at rest; single hits and disturbances; what the fit leaves open;
// weak excitation and missing statements; remarks. A cause stands before its consequence: split modes and missing modes
// before the residual that they leave.
constexpr auto kRanking = std::to_array<RankedCode>({
    {"reversed_phase", Severity::reject},
    {"hits_disagree", Severity::reject},
    {"swapped_channels", Severity::reject},
    {"units_differ", Severity::reject},
    {"implausible_motion", Severity::reject},
    {"reversed", Severity::reject},
    {"sensors_disagree", Severity::reject},
    {"clock_mismatch", Severity::reject},
    {"polarity", Severity::reject},
    {"dead_channel", Severity::reject},
    {"already_windowed", Severity::reject},
    {"aliasing", Severity::reject},
    {"force_clipped", Severity::reject},
    {"response_clipped", Severity::reject},
    {"files_disagree", Severity::warn},
    {"files_as_points", Severity::warn},
    {"same_motion", Severity::warn},
    {"angles_contradicted", Severity::warn},
    {"midway_hit", Severity::warn},
    {"order_missing", Severity::warn},
    {"duplicate", Severity::warn},
    {"lost_samples", Severity::warn},
    {"capture_clock", Severity::warn},
    {"dropout", Severity::warn},
    {"skew", Severity::warn},
    {"zero_shift", Severity::warn},
    {"ac_coupling", Severity::warn},
    {"drifting", Severity::warn},
    {"moving_modes", Severity::warn},
    {"nonlinear", Severity::warn},
    {"hits_differ", Severity::warn},
    {"mass_loading", Severity::warn},
    {"not_at_rest", Severity::warn},
    {"dropped_points", Severity::warn},
    {"accept_refused", Severity::warn},
    {"start_refused", Severity::warn},
    {"start_between", Severity::warn},
    {"outlier", Severity::warn},
    {"misplaced_hits", Severity::warn},
    {"implausible_force", Severity::warn},
    {"low_coherence", Severity::warn},
    {"overload", Severity::warn},
    {"double_hit", Severity::warn},
    {"double_hits_used", Severity::warn},
    {"no_pulse", Severity::warn},
    {"no_free_decay", Severity::warn},
    {"late_trigger", Severity::warn},
    {"short_hit", Severity::warn},
    {"coarse_steps", Severity::warn},
    {"hum", Severity::warn},
    {"tone", Severity::warn},
    {"pair_or_scatter", Severity::warn},
    {"cut_decay", Severity::warn},
    {"disturbed_decay", Severity::warn},
    {"uneven_decay", Severity::warn},
    {"spike", Severity::warn},
    {"double_peak", Severity::warn},
    {"repeated_modes", Severity::warn},
    {"sensor_on_node", Severity::warn},
    {"narrow_arc", Severity::warn},
    {"driving_point_numbers", Severity::warn},
    {"driving_point_sign", Severity::warn},
    {"reciprocity", Severity::warn},
    {"no_modes", Severity::warn},
    {"unclaimed_peaks", Severity::warn},
    {"unmodelled_poles", Severity::warn},
    {"crowded", Severity::warn},
    {"local_fits", Severity::warn},
    {"model_misfit", Severity::warn},
    {"frac", Severity::warn},
    {"assumed_tube", Severity::warn},
    {"short_pretrigger", Severity::warn},
    {"low_bandwidth", Severity::warn},
    {"weak", Severity::warn},
    {"force_noise_unknown", Severity::warn},
    {"hammer_as_response", Severity::warn},
    {"not_told", Severity::warn},
    {"modes_alone", Severity::warn},
    {"not_free", Severity::warn},
    {"larger_later", Severity::warn},
    {"drift", Severity::warn},
    {"no_rest", Severity::warn},
    {"missing_position", Severity::warn},
    {"few_points", Severity::warn},
    {"input", Severity::warn},
    {"not_a_tube", Severity::info},
    {"three_waves", Severity::info},
    {"offset", Severity::info},
    {"capture_lost_samples", Severity::info},
    {"capture_ended", Severity::info},
    {"rejected_live", Severity::info},
    {"earlier_ringing", Severity::info},
    {"unexcited_channel", Severity::info},
    {"rejected_hits", Severity::info},
    {"one_hit_each", Severity::info},
    {"below_band", Severity::info},
    {"truncated_decay", Severity::info},
    {"no_geometry", Severity::info},
    {"points_from_one", Severity::info},
    {"files_in_order", Severity::info},
    {"missing_points", Severity::info},
    {"geometry_unit_assumed", Severity::info},
    {"no_force", Severity::info},
});

// The hits that share one finding.
struct SharedFinding {
  std::vector<std::size_t> used, rejected;
  const acquire::Finding *first_used = nullptr, *first_rejected = nullptr;
};

Warning statement_of(const SharedFinding& shared) {
  const bool used = !shared.used.empty();
  std::string who = used ? hit_list(shared.used) : hit_list(shared.rejected) + " (not used)";
  if (used && !shared.rejected.empty()) who += " and " + hit_list(shared.rejected) + " (not used)";
  const std::size_t count = shared.used.size() + shared.rejected.size();
  const acquire::Finding& first = used ? *shared.first_used : *shared.first_rejected;
  return {.code = name_of(first.code),
          .message = fmt::format("{}: {}{}", who, first.message, count > 1 ? " (the first of them)" : ""),
          .options = first.options,
          .severity = used ? first.severity : Severity::info};
}

bool states(const std::vector<Warning>& warnings, std::string_view code) {
  return std::any_of(warnings.begin(), warnings.end(), [&](const Warning& warning) { return warning.code == code; });
}

}  // namespace

std::span<const RankedCode> ranked_codes() { return kRanking; }

Severity severity_of(std::string_view code) { return warnings::severity_of(code, kRanking); }

std::vector<Warning> ranked(std::vector<Warning> warnings) { return warnings::ranked(std::move(warnings), kRanking); }

std::vector<Warning> trust_statements(const std::vector<Warning>& warnings, const std::vector<AnalysedHit>& hits) {
  std::map<acquire::FindingCode, SharedFinding> findings;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    for (const acquire::Finding& finding : hits[h].hit.findings) {
      SharedFinding& shared = findings[finding.code];
      const acquire::Finding*& first = hits[h].accepted ? shared.first_used : shared.first_rejected;
      if (first == nullptr) first = &finding;
      auto& list = hits[h].accepted ? shared.used : shared.rejected;
      if (list.empty() || list.back() != h) list.push_back(h);
    }
  }
  std::vector<Warning> out;
  for (const Warning& warning : warnings) {
    if (std::none_of(out.begin(), out.end(), [&](const Warning& known) { return known.message == warning.message; }))
      out.push_back(warning);
  }
  for (auto& [code, shared] : findings) {
    // A warning with the code of a finding summarises it; double_hits_used does so for the hits that are used.
    if (states(warnings, name_of(code))) continue;
    if (code == acquire::FindingCode::double_hit && states(warnings, "double_hits_used")) shared.used.clear();
    if (!shared.used.empty() || !shared.rejected.empty()) out.push_back(statement_of(shared));
  }
  return ranked(std::move(out));
}

}  // namespace percuss::pipeline
