#include "pipeline/warnings/deflection_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/io/counted_words.hpp"
#include "core/units.hpp"
#include "pipeline/warnings/hit_list.hpp"

namespace percuss::pipeline {
namespace {

bool by_modes(const DeflectionResults& test) {
  return std::any_of(test.deflections.begin(), test.deflections.end(),
                     [](const auto& of) { return of.deflection->method == metrics::DeflectionMethod::modal; });
}

// A remedy recommends neither the method that failed nor a method whose input was not recorded.
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

// The effective mass needs the force.
bool mass_would_help(const DeflectionResults& test) { return test.has_force && !test.mass_known; }

// Motion that the largest deflections stated do not show.
void add_motion_left_out(const DeflectionResults& test, std::vector<Warning>& out) {
  const auto growing = std::count_if(test.deflections.begin(), test.deflections.end(), [](const auto& of) {
    return of.deflection->larger_later && !of.deflection->rigid_motion_contradicted;
  });
  if (growing > 0) {
    const bool mass = mass_would_help(test);
    out.push_back(with_remedy(
        {"larger_later",
         fmt::format(
             "{} of {} deflections become larger after the value stated, but their ± grows faster: the value stated is "
             "the one that exceeds its ± most; it may not be the largest of the motion",
             growing, test.deflections.size()),
         mass ? std::vector<OptionId>{"effective_mass"} : std::vector<OptionId>{}},
        std::string("record with more pre-trigger") +
            (mass ? "; if nothing pulls the structure back within the record, state its effective mass at the struck "
                    "point"
                  : "")));
  }
  const bool modes_alone = std::any_of(test.deflections.begin(), test.deflections.end(),
                                       [](const auto& of) { return of.deflection->rigid_motion_left_out; });
  if (modes_alone) {
    out.push_back(with_remedy({"modes_alone",
                               "the modal deflections hold the vibration of the identified modes alone. The motion of "
                               "the structure as a whole is left out: how it moves away, or swings on its suspension",
                               {"method", "effective_mass"}},
                              "do nothing if the vibration alone is wanted. For the whole motion: choose the method "
                              "drift-free if the structure hangs on bands or strings; state its effective mass at the "
                              "struck point if nothing pulls it back within the record"));
  }
}

// Modal deflections with the motion of a free body that the acceleration contradicts.
void add_not_free(const DeflectionResults& test, std::vector<Warning>& out) {
  const auto count = std::count_if(test.deflections.begin(), test.deflections.end(),
                                   [](const auto& of) { return of.deflection->rigid_motion_contradicted; });
  if (count == 0) return;
  out.push_back(with_remedy(
      {"not_free",
       fmt::format(
           "{} of {} deflections do not move as a free body of the stated mass: the acceleration, integrated twice, "
           "shows another motion. Each ± includes the difference, which grows with time; the value stated comes "
           "before it, and larger ones may follow. Possible causes: a suspension that pulls the structure back, "
           "a wrong mass, a sensor that does not lie along the blow, an accelerometer whose zero shifts or that has a "
           "high-pass",
           count, test.deflections.size()),
       {"method", "effective_mass"}},
      "if the structure hangs on bands or strings, choose the method drift-free and leave the mass out; otherwise "
      "check the mass and the sensor"));
}

// Hits before which the structure was not at rest. The modal method gives the deflection of this blow alone. The other
// methods integrate from a wrong initial velocity.
void add_moving(const DeflectionResults& test, std::vector<Warning>& out) {
  std::vector<std::size_t> modal, integrated;
  for (const std::size_t hit : test.moving) {
    const bool integrates = std::any_of(test.deflections.begin(), test.deflections.end(), [&](const auto& of) {
      return of.hit == hit && of.deflection->method != metrics::DeflectionMethod::modal;
    });
    (integrates ? integrated : modal).push_back(hit);
  }
  if (!integrated.empty()) {
    out.push_back(with_remedy(
        {"not_at_rest",
         "the structure was not at rest before " + hit_list(integrated) +
             ": the integration begins with a wrong velocity, and the deflection may be off by "
             "far more than its ±",
         test.has_force ? std::vector<OptionId>{"method"} : std::vector<OptionId>{}},
        test.has_force ? "wait longer between hits, or choose the method modal" : "wait longer between hits"));
  }
  if (!modal.empty()) {
    out.push_back({"earlier_ringing", "the structure was not at rest before " + hit_list(modal) +
                                          ": the deflection stated is what this blow alone adds, from the modes"});
  }
}

// Hits before which the structure swayed too slowly for add_moving(): the acceleration before them is a line.
void add_swaying(const DeflectionResults& test, std::vector<Warning>& out) {
  std::vector<std::size_t> swaying;
  for (const auto& of : test.deflections) {
    if (of.deflection->moved_before && (swaying.empty() || swaying.back() != of.hit)) swaying.push_back(of.hit);
  }
  if (swaying.empty()) return;
  out.push_back(with_remedy(
      {"not_at_rest",
       "before " + hit_list(swaying) +
           " the acceleration is not at its level before the first hit: the structure still swayed, and its sway is "
           "no bias of the sensor. The ± includes the difference; the sway itself is not part of the deflection"},
      "wait longer between hits"));
}

// The accelerometers' coupling does not show in their own samples. The force's does, and one recorder often couples all
// channels alike. A high-pass with the corner f changes a deflection by the share 2πft at the time t after the impact.
void add_coupling(const DeflectionResults& test, std::vector<Warning>& out) {
  const bool matters =
      test.coupling_Hz > 0 && std::any_of(test.deflections.begin(), test.deflections.end(), [&](const auto& of) {
        const metrics::Deflection& d = *of.deflection;
        const double time_s = static_cast<double>(d.peak) / of.fs_Hz - of.onset_s;
        return d.method != metrics::DeflectionMethod::modal && d.has_peak() &&
               kTwoPi * test.coupling_Hz * time_s * std::abs(d.peak_m) > d.peak_std_m;
      });
  if (!matters) return;
  out.push_back(with_remedy(
      {"ac_coupling",
       fmt::format("the force undershoots after each pulse: its channel is AC-coupled, with a corner of {:.2g} Hz. If "
                   "the accelerations have it, too, their deflections are off by far more than their ±",
                   test.coupling_Hz),
       {"highpass_corner"}},
      fmt::format("couple the channels by DC; or, if all channels are coupled alike, state the high-pass corner of "
                  "{:.2g}",
                  test.coupling_Hz)));
}

// "hit 2 (227 samples), hit 5 (1 sample)"
std::string list_of_clipped_impacts(const std::vector<DeflectionResults::ClippedImpact>& impacts) {
  constexpr std::size_t kMaxListed = 8;
  return limited_list(impacts.size(), kMaxListed, [&](std::size_t i) {
    return fmt::format("hit {} ({} sample{})", impacts[i].hit + 1, impacts[i].samples, plural(impacts[i].samples));
  });
}

void add_clipped(const DeflectionResults& test, std::vector<Warning>& out) {
  if (!test.clipped_left_out.empty()) {
    const bool modal = test.has_force && test.clipped_left_out.size() < test.impacts;
    const std::string by_modes =
        modal ? ", or choose the method modal, which takes the modes of the other hits and the force of these" : "";
    out.push_back(with_remedy(
        {"response_clipped",
         fmt::format("an acceleration is clipped in {}: left out, because the integrals miss the motion beyond the "
                     "limit and drift",
                     list_of_clipped_impacts(test.clipped_left_out)),
         modal ? std::vector<OptionId>{"method", "accept_hit"} : std::vector<OptionId>{"accept_hit"},
         {},
         acquire::Severity::warn},
        "raise the input range" + by_modes + "; to see such a deflection all the same, accept its hit"));
  }
  if (!test.clipped_used.empty()) {
    out.push_back(with_remedy(
        {"response_clipped",
         fmt::format("an acceleration is clipped in {}, accepted by the user: the deflection is off by far more than "
                     "its ±",
                     list_of_clipped_impacts(test.clipped_used))},
        "raise the input range"));
  }
}

}  // namespace

std::vector<Warning> deflection_warnings(const DeflectionResults& test) {
  std::vector<Warning> out;
  if (test.without_pulse > 0) {
    out.push_back(with_remedy(
        {"no_pulse", fmt::format("{} of {} hits show no impact and are left out", test.without_pulse, test.impacts)},
        "check the cables and the channels of these hits"));
  }
  add_clipped(test, out);
  add_coupling(test, out);
  if (!test.rest_recorded) {
    out.push_back(with_remedy(
        {"no_rest", "a record begins too late to contain the rest before the impact, from which the bias is estimated"},
        "record with more pre-trigger"));
  }
  add_moving(test, out);
  add_swaying(test, out);
  const auto unknown = std::count_if(test.deflections.begin(), test.deflections.end(),
                                     [](const auto& of) { return !of.deflection->has_peak(); });
  if (unknown > 0) {
    out.push_back(with_remedy({"not_told",
                               fmt::format("{} of {} deflections do not exceed four times their own uncertainty "
                                           "where they are largest, and have no largest value",
                                           unknown, test.deflections.size()),
                               options_against_unknown(test)},
                              remedy_against_unknown(test)));
  }
  add_motion_left_out(test, out);
  add_not_free(test, out);
  const bool drifts = std::any_of(test.deflections.begin(), test.deflections.end(), [](const auto& of) {
    return of.deflection->method == metrics::DeflectionMethod::drift_free && !of.deflection->zero_mean_corrected;
  });
  if (drifts && test.mass_known) {
    out.push_back(with_remedy(
        {"drift",
         "after the rigid-body motion of the stated effective mass is subtracted, the structure does not return to its "
         "rest position, or the record is too short to show that it does: the mass has no effect, late deflections "
         "drift, and their ± includes the drift",
         {"effective_mass", "free_body"}},
        "if the structure hangs on bands or strings, which pull it back, leave the mass out and say that the structure "
        "may move away; otherwise check the mass, or record with more pre-trigger"));
  } else if (drifts && !test.free_body) {
    out.push_back(with_remedy(
        {"drift",
         "the structure does not return to its rest position, or the record is too short or too noisy to show that it "
         "does: late deflections drift, and their ± includes the drift",
         test.has_force ? std::vector<OptionId>{"free_body", "effective_mass", "to", "method"}
                        : std::vector<OptionId>{"free_body", "to"}},
        test.has_force
            ? "if the structure hangs on bands or strings, nothing is wrong: say that it may move away. If nothing "
              "pulls it back within the record, state its effective mass at the struck point. If it is held and swings "
              "at the end, record longer; if noise hides its last swings, end the record before; or choose the method "
              "modal, if the band holds the lowest modes"
            : "if the structure hangs on bands or strings, or flies away, nothing is wrong: say that it may move away. "
              "If it is held and swings at the end, record longer; if noise hides its last swings, end the record "
              "before"));
  }
  return out;
}

}  // namespace percuss::pipeline
