#include "pipeline/survey_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "core/parallel/parallel.hpp"
#include "pipeline/channels/channel_clocks.hpp"
#include "pipeline/stages/mode_stages.hpp"
#include "pipeline/warnings/hit_scatter_warnings.hpp"
#include "pipeline/warnings/mode_warnings.hpp"
#include "pipeline/warnings/reference_warnings.hpp"

namespace percuss::pipeline {
namespace {

std::vector<identify::DrivingPoint> with_point_indices(std::vector<identify::DrivingPoint> driving,
                                                       const std::vector<int>& points) {
  for (identify::DrivingPoint& at : driving) {
    const auto place = std::lower_bound(points.begin(), points.end(), static_cast<int>(at.point));
    at.point = static_cast<std::size_t>(place - points.begin());
  }
  return driving;
}

void set_point_numbers(identify::Mode& mode, const std::vector<int>& points) {
  for (identify::Residue& residue : mode.residues) residue.point = static_cast<std::size_t>(points[residue.point]);
}

bool any_resolved(const SurveyModes& survey) {
  return std::any_of(survey.pairs.begin(), survey.pairs.end(), [](const auto& pair) { return pair.resolved; });
}

}  // namespace

SurveyModes survey_modes(const Analysis& analysis, identify::Roving roving,
                         const std::vector<identify::DrivingPoint>& driving) {
  SurveyModes out;
  const std::vector<identify::Mode>& found = analysis.modes();
  const auto several = [](const identify::Mode& mode) { return identify::test_rank(mode).two_modes(); };
  // A sensor that was reversed or moved at some points also makes the residues rank two (sensors_disagree).
  const bool may_repeat = roving == identify::Roving::hammer && std::any_of(found.begin(), found.end(), several) &&
                          reference_warnings(analysis.record().accel, found, analysis.point_names()).empty();
  const std::vector<int> points = may_repeat ? analysis.frf_points() : std::vector<int>{};
  // All modes of the fit, for the flanks of the neighbours.
  const std::vector<identify::Mode> all =
      may_repeat ? with_point_indices(analysis.fitted_modes(), points) : std::vector<identify::Mode>{};
  const std::vector<identify::DrivingPoint> driving_index = with_point_indices(driving, points);
  const ThreadLimit limit(analysis.options().threads);
  for (std::size_t m = 0; m < found.size(); ++m) {
    const auto same = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.pole == found[m].pole; });
    std::optional<identify::RepeatedPair> pair;
    if (same != all.end()) {
      pair = identify::repeated_pair(analysis.fitted_frfs(), all, static_cast<std::size_t>(same - all.begin()),
                                     driving_index);
    }
    if (!pair) {
      out.modes.push_back(found[m]);
      out.of_analysis.push_back(m);
      continue;
    }
    out.pairs.push_back({.first = out.modes.size(), .resolved = pair->resolved, .split_std_Hz = pair->split_std_Hz});
    for (identify::Mode* one : {&pair->first, &pair->second}) {
      set_point_numbers(*one, points);
      out.modes.push_back(std::move(*one));
      out.of_analysis.push_back(m);
    }
  }
  return out;
}

std::vector<identify::ModeClassification> classify_by_sensors(const Analysis& analysis, const SurveyModes& survey) {
  if (survey.pairs.empty()) return analysis.classifications();
  std::vector<identify::ModeClassification> out =
      classify_modes(survey.modes, analysis.fitted_frfs(), analysis.typing_accel(), analysis.options().classes);
  const identify::LowerOrders& lower = analysis.lower_orders();
  for (identify::ModeClassification& mode : out) {
    if (!analysis.modes_are_complete()) mode.order = 0;
    if (mode.order > 0) mode.order += mode.type == identify::ModeType::hoop ? lower.hoop : lower.bending;
  }
  return out;
}

std::vector<std::size_t> unresolved_modes(const SurveyModes& survey) {
  std::vector<std::size_t> out;
  for (const SurveyModes::Pair& pair : survey.pairs) {
    if (!pair.resolved) out.insert(out.end(), {pair.first, pair.first + 1});
  }
  return out;
}

std::vector<Warning> repeated_mode_warnings(const SurveyModes& survey, bool driving_point) {
  std::string names;
  for (const SurveyModes::Pair& pair : survey.pairs) {
    if (pair.resolved) continue;
    names += fmt::format("{}{} and {} ({:.1f} Hz, less than {:.2g} Hz apart)", names.empty() ? "" : ", ",
                         pair.first + 1, pair.first + 2, survey.modes[pair.first].pole.freq_Hz, 2 * pair.split_std_Hz);
  }
  if (names.empty()) return {};
  return {
      with_remedy({"repeated_modes",
                   "the sensors see two shapes at one frequency, which are two modes: " + names +
                       (driving_point ? ". Every combination of the two shapes is a mode, too; the first listed one "
                                        "has all the motion of one sensor, and the second has none of it"
                                      : ". Every combination of the two shapes is a mode, too; without a driving "
                                        "point, the listed ones are orthogonal on these points")},
                  "add a small mass on one side to separate the two and to find their planes")};
}

void remove_consequences_of_pairs(const Analysis& analysis, const SurveyModes& survey, std::vector<Warning>& warnings) {
  if (!any_resolved(survey)) return;
  constexpr std::array<std::string_view, 4> kOfModes{"moving_modes", "hits_differ", "local_fits", "model_misfit"};
  const bool enough_unpaired = survey.modes.size() - 2 * survey.pairs.size() >= kMinClockModes;
  const bool force_known = analysis.given_frfs() == nullptr;
  std::vector<Warning> again = freq_scatter_warnings(
      survey.modes, force_known ? order_of_points(analysis.hits()) : std::map<int, double>{}, force_known);
  for (std::vector<Warning> more :
       {hit_scatter_warnings(survey.modes, std::nullopt, force_known), local_fit_warnings(survey.modes, force_known)})
    again.insert(again.end(), more.begin(), more.end());
  for (const std::string_view code : kOfModes) {
    const auto has_code = [&](const Warning& warning) { return warning.code == code; };
    const auto old = std::find_if(warnings.begin(), warnings.end(), has_code);
    const auto now = std::find_if(again.begin(), again.end(), has_code);
    if (old == warnings.end()) continue;
    if (now == again.end()) {
      warnings.erase(old);
    } else {
      *old = *now;
    }
  }
  if (!enough_unpaired)
    std::erase_if(warnings, [](const Warning& warning) { return warning.code == "clock_mismatch"; });
}

}  // namespace percuss::pipeline
