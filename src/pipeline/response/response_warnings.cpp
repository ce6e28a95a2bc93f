#include "pipeline/response/response_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>

#include "acquire/channels/role_guess.hpp"
#include "acquire/channels/unit_notes.hpp"
#include "core/error.hpp"
#include "pipeline/hits/hit_grading.hpp"
#include "pipeline/response/missing_results.hpp"
#include "pipeline/warnings/channel_warnings.hpp"
#include "pipeline/warnings/hit_list.hpp"
#include "pipeline/warnings/object_warnings.hpp"
#include "pipeline/warnings/ranking.hpp"
#include "pipeline/warnings/three_wave_warnings.hpp"

namespace percuss::pipeline {
namespace {

Warning no_force() {
  return with_remedy(
      {"no_force",
       "no force was recorded: modes come from the free decays. FRFs, coherence, residues in 1/kg, modal "
       "masses and the grading of the hits by their force are not known",
       {"force_channel"},
       {},
       acquire::Severity::info},
      "name the force's channel, if there is one");
}

// The reader's notes. If the unit of a response is not stated, notes ask for units and scales that no result needs: one
// remark replaces them.
std::vector<Warning> notes_of(const ResponseTest& test) {
  acquire::Record record;
  record.notes = test.record.notes;
  const std::size_t dropped = std::erase_if(record.notes, acquire::is_about_assumed_units);
  std::vector<Warning> out = input_warnings(record);
  if (dropped == 0 || !test.possible()) return out;
  const char* const which = test.record.accel.size() > 1
                                ? "amplitudes are relative, and shapes hold if all channels have one scale"
                                : "amplitudes are relative";
  out.push_back(
      {.code = "input",
       .message = fmt::format("no unit is stated, so {}. Frequencies and damping ratios do not depend on it", which),
       .options = {"unit"},
       .severity = acquire::Severity::info});
  return out;
}

double hammer_dissimilarity_of(const acquire::Record& record, std::size_t channel) {
  std::vector<double> samples;
  for (std::size_t row = 0; row < record.rows.size() && samples.size() < acquire::kGuessedSamples; ++row) {
    const std::size_t count = std::min(record.rows[row].samples, acquire::kGuessedSamples - samples.size());
    samples.resize(samples.size() + count);
    record.read_accel_mps2(row, channel, 0, std::span(samples).last(count));
  }
  return acquire::hammer_dissimilarity(samples);
}

// A hammer among the responses: its samples look like pulses, and those of the other responses do not.
std::vector<Warning> hammer_as_response(const acquire::Record& record) {
  std::vector<double> measures;
  for (std::size_t c = 0; c < record.accel.size(); ++c) measures.push_back(hammer_dissimilarity_of(record, c));
  if (measures.size() < 2) return {};
  const auto smallest = std::min_element(measures.begin(), measures.end());
  const auto alike = std::count_if(measures.begin(), measures.end(), [&](double measure) {
    return measure <= acquire::kMaxDissimilarityRatio * *smallest;
  });
  if (!(*smallest < acquire::kMaxHammerDissimilarity) || alike > 1) return {};
  const auto hammer = static_cast<std::size_t>(smallest - measures.begin());
  const std::string name = one_line(record.accel[hammer].name, kMaxNameBytes);
  return {with_remedy({"hammer_as_response",
                       name + " looks like the hammer's pulses, but is analysed as a response",
                       {"force_channel", "accel_channel", "force_unit"}},
                      fmt::format("name {} as the force and the others as accelerations, and the unit of the force if "
                                  "the file states another",
                                  name))};
}

// Whether many neighbouring oscillations of the fit are less than kLines spectral lines apart. A fit describes a motion
// that is no sum of decays by such a comb, whose spacing is the inverse of the time that the motion lasts.
bool is_comb(const ResponseTest& test) {
  constexpr std::size_t kTeeth = 8;
  constexpr double kLines = 3;
  std::vector<double> freq_Hz;
  for (const auto* list : {&test.found.modes, &test.found.tones}) {
    for (const identify::DecayMode& one : *list) freq_Hz.push_back(one.mode.pole.freq_Hz);
  }
  std::sort(freq_Hz.begin(), freq_Hz.end());
  std::size_t teeth = 0;
  for (std::size_t i = 1; i < freq_Hz.size(); ++i) {
    const double lines = (freq_Hz[i] - freq_Hz[i - 1]) * static_cast<double>(test.samples) / test.record.fs_Hz;
    if (lines < kLines) ++teeth;
  }
  return teeth >= kTeeth;
}

// What the recorder did to the decays, and what disturbed them.
std::vector<Warning> damaged_decays(const ResponseTest& test) {
  double clipped_s = 0;
  bool gated = false, shortened = false;
  for (const ResponseHit& hit : test.hits) {
    clipped_s = std::max(clipped_s, hit.clipped_s);
    gated = gated || hit.gated;
    shortened = shortened || hit.shortened;
  }
  std::vector<Warning> out;
  if (clipped_s > 0) {
    out.push_back(with_remedy(
        {"response_clipped",
         fmt::format("the responses are clipped up to {:.2g} s after the impacts: the modes come from the motion after "
                     "that, and modes that have died out by then are missing",
                     clipped_s),
         {},
         {},
         acquire::Severity::warn},
        "lower the gain of the recorder, or strike more softly"));
  }
  if (gated) {
    out.push_back(with_remedy({"cut_decay",
                               "the recorder cuts decays off (its samples become constant while the structure still "
                               "moves): only the motion before that is used"},
                              "switch off the recorder's noise gate and automatic gain"));
  }
  if (is_comb(test)) {
    out.push_back(with_remedy({"disturbed_decay",
                               "many oscillations lie side by side, nearer than the length of the decays resolves: the "
                               "motion is no sum of free decays, as with an unseen blow or contact within them, or an "
                               "automatic gain. The modes are not reliable",
                               {"from", "to", "reject_hit"},
                               {},
                               acquire::Severity::reject},
                              "record in less noise, with one blow at a time, or use only a quiet part"));
  } else if (shortened) {
    out.push_back(with_remedy(
        {"disturbed_decay", "another blow or a contact follows each impact: only the motion before that is used"},
        "leave time between the blows, and touch nothing until the motion has died out"));
  }
  return out;
}

std::vector<Warning> tones(const ResponseTest& test) {
  std::string list;
  for (const identify::DecayMode& tone : test.found.tones)
    list += fmt::format("{}{:.5g} Hz", list.empty() ? "" : ", ", tone.mode.pole.freq_Hz);
  if (list.empty()) return {};
  return {{"tone", fmt::format("{}: the damping is within three standard deviations of zero: hum, a machine, or a mode "
                               "whose decay this test does not show",
                               list)}};
}

void add_near(double freq_Hz, const std::vector<double>& near_Hz, std::string& list) {
  if (near_Hz.empty()) return;
  std::vector<std::string> near;
  near.reserve(near_Hz.size());
  for (const double other_Hz : near_Hz) near.push_back(fmt::format("{:.5g}", other_Hz));
  list += fmt::format("{}{:.5g} Hz (also {} Hz)", list.empty() ? "" : "; ", freq_Hz, fmt::join(near, ", "));
}

std::vector<Warning> uneven_decays(const ResponseTest& test) {
  std::string gathered, unresolved;
  for (const identify::DecayMode& mode : test.found.modes) {
    std::vector<double> companions_Hz;
    companions_Hz.reserve(mode.companions.size());
    for (const identify::DecayMode& other : mode.companions) companions_Hz.push_back(other.mode.pole.freq_Hz);
    add_near(mode.mode.pole.freq_Hz, companions_Hz, gathered);
    add_near(mode.mode.pole.freq_Hz, mode.unresolved_Hz, unresolved);
  }
  std::vector<Warning> out;
  const auto add = [&](std::string text) {
    out.push_back(with_remedy({"uneven_decay", std::move(text)},
                              "strike with less and with more force and compare; check for friction and loose parts"));
  };
  if (!gathered.empty()) {
    add(
        fmt::format("these decays are not exponential; their fit needs further oscillations of the same shape: {}. One "
                    "mode whose frequency or damping changes with its amplitude has such a decay, and so have close "
                    "modes that the channels show alike; the ± cover both",
                    gathered));
  }
  if (!unresolved.empty()) {
    add(
        fmt::format("three or more listed modes lie within a bandwidth: {}. They may be fewer modes whose frequency or "
                    "damping changes with the amplitude; one or two channels cannot tell, and the ± do not cover it",
                    unresolved));
  }
  return out;
}

// accept_refused: the hits that the user accepts, but that cannot be used.
std::vector<Warning> refused_hits(const ResponseTest& test) {
  std::vector<std::size_t> refused;
  for (std::size_t h = 0; h < test.hits.size(); ++h) {
    if (names_hit(test.options.accept_hits, test.options.reject_hits, h) && !can_be_accepted(test.hits[h]))
      refused.push_back(h);
  }
  if (refused.empty()) return {};
  return {with_remedy({"accept_refused",
                       fmt::format("{} cannot be accepted: fewer than {} samples follow the impact", hit_list(refused),
                                   kMinDecaySamples),
                       {"accept_hit"}},
                      "record longer after each impact")};
}

std::vector<Warning> pairs_or_scatter(const ResponseTest& test) {
  std::string list;
  for (const identify::DecayMode& mode : test.found.modes) {
    if (!mode.alternative_pair_Hz) continue;
    list += fmt::format("{}{:.6g} Hz (or {:.6g} and {:.6g} Hz)", list.empty() ? "" : ", ", mode.mode.pole.freq_Hz,
                        mode.alternative_pair_Hz->first, mode.alternative_pair_Hz->second);
  }
  if (list.empty()) return {};
  return {with_remedy({"pair_or_scatter",
                       fmt::format("one mode whose frequency differs between the hits, or two close modes, which this "
                                   "test cannot decide: {}",
                                   list)},
                      "strike with equal force, at points that excite the two modes differently, or more often")};
}

}  // namespace

std::vector<Warning> response_warnings(const ResponseTest& test) {
  std::vector<Warning> out = test.options.known;
  const auto add = [&](std::vector<Warning> more) {
    out.insert(out.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  add(notes_of(test));
  add(hammer_as_response(test.record));
  out.push_back(no_force());
  add(missing_result_warnings(test));
  add(refused_hits(test));
  std::vector<LostSamples> lost;
  for (const ResponseHit& hit : test.hits) {
    if (hit.accepted && hit.lost) lost.push_back(*hit.lost);
  }
  add(lost_samples_warning(lost, "the longer part of the decay, before or after the gap, is used"));
  add(damaged_decays(test));
  add(uneven_decays(test));
  add(tones(test));
  add(pairs_or_scatter(test));
  add(object_warnings(test.classifications, test.options.classes));
  std::vector<identify::Mode> modes;
  for (const identify::DecayMode& one : test.found.modes) modes.push_back(one.mode);
  add(three_wave_warnings(modes, test.classifications));
  return ranked(std::move(out));
}

}  // namespace percuss::pipeline
