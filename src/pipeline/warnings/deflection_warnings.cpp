#include "pipeline/warnings/deflection_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/warnings/ranking.hpp"

namespace percuss::pipeline {
namespace {

bool by_modes(const DeflectionResults& test) {
  return std::any_of(test.deflections.begin(), test.deflections.end(), [](const metrics::Deflection* deflection) {
    return deflection->method == metrics::DeflectionMethod::modal;
  });
}

// Each remedy leads away from the method that failed, and none to a method that needs what was not recorded.
const char* remedy_against_unknown(const DeflectionResults& test) {
  if (!by_modes(test)) {
    return test.has_force
               ? "record with more pre-trigger, or choose the method modal if the band holds the lowest modes"
               : "record with more pre-trigger";
  }
  return test.mass_known
             ? "extend the band down to the lowest mode, or choose the method drift-free"
             : "extend the band down to the lowest mode, state the effective mass of a free body, or choose "
               "the method drift-free";
}

std::vector<OptionId> options_against_unknown(const DeflectionResults& test) {
  if (!by_modes(test)) return test.has_force ? std::vector<OptionId>{"method"} : std::vector<OptionId>{};
  if (test.mass_known) return {"band", "method"};
  return {"band", "effective_mass", "method"};
}

// Motion that the largest deflections stated do not show.
void add_motion_left_out(const DeflectionResults& test, std::vector<Warning>& out) {
  const auto growing = std::count_if(test.deflections.begin(), test.deflections.end(),
                                     [](const metrics::Deflection* deflection) { return deflection->larger_later; });
  if (growing > 0) {
    out.push_back(with_remedy(
        {"larger_later",
         fmt::format("{} of {} deflections grow on after the largest value stated, but their ± grows faster: the value "
                     "stated is the one that exceeds its ± most, not the end of the motion",
                     growing, test.deflections.size()),
         {"effective_mass"}},
        "record with more pre-trigger; for a free structure, state its effective mass at the struck point"));
  }
  const bool modes_alone =
      std::any_of(test.deflections.begin(), test.deflections.end(),
                  [](const metrics::Deflection* deflection) { return deflection->rigid_motion_left_out; });
  if (modes_alone) {
    out.push_back(with_remedy({"modes_alone",
                               "the modal deflections hold the vibration of the identified modes alone: the rigid-body "
                               "motion of a free structure is left out",
                               {"effective_mass"}},
                              "for a free structure, state its effective mass at the struck point"));
  }
}

}  // namespace

std::vector<Warning> deflection_warnings(const DeflectionResults& test) {
  std::vector<Warning> out;
  if (test.used < test.impacts) {
    out.push_back(with_remedy({"no_pulse", fmt::format("{} of {} hits show no impact and are left out",
                                                       test.impacts - test.used, test.impacts)},
                              "check the cables and the channels of these hits"));
  }
  if (!test.rest_recorded) {
    out.push_back(with_remedy(
        {"no_rest", "a record begins too late to contain the rest before the impact, from which the bias is estimated"},
        "record with more pre-trigger"));
  }
  const auto unknown = std::count_if(test.deflections.begin(), test.deflections.end(),
                                     [](const metrics::Deflection* deflection) { return !deflection->has_peak(); });
  if (unknown > 0) {
    out.push_back(with_remedy({"not_told",
                               fmt::format("{} of {} deflections never exceed four times their own uncertainty and "
                                           "have no largest value",
                                           unknown, test.deflections.size()),
                               options_against_unknown(test)},
                              remedy_against_unknown(test)));
  }
  add_motion_left_out(test, out);
  const bool drifts = std::any_of(test.deflections.begin(), test.deflections.end(), [](const auto* deflection) {
    return deflection->method == metrics::DeflectionMethod::drift_free && !deflection->zero_mean_corrected;
  });
  if (drifts && !test.free_body) {
    out.push_back(with_remedy(
        {"drift",
         "the structure does not return to its rest position, or the record is too short to show that it "
         "does: late deflections drift, and their ± includes the drift",
         test.has_force ? std::vector<OptionId>{"method", "free_body", "effective_mass"}
                        : std::vector<OptionId>{"free_body", "effective_mass"}},
        test.has_force ? "for a held structure, choose the method modal if the band holds the lowest modes; for a free "
                         "one, say that it is free and state its effective mass at the struck point"
                       : "for a free structure, say that it is free and state its effective mass at the struck point"));
  }
  return ranked(std::move(out));
}

}  // namespace percuss::pipeline
