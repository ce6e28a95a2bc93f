#include "pipeline/response/response_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/warnings/channel_warnings.hpp"
#include "pipeline/warnings/object_warnings.hpp"
#include "pipeline/warnings/ranking.hpp"

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

std::vector<Warning> tones(const ResponseTest& test) {
  std::string list;
  for (const identify::DecayMode& tone : test.found.tones)
    list += fmt::format("{}{:.5g} Hz", list.empty() ? "" : ", ", tone.mode.pole.freq_Hz);
  if (list.empty()) return {};
  return {{"tone", fmt::format("{}: no decay within three standard deviations, so this is no mode of the structure "
                               "but hum or a machine",
                               list)}};
}

std::vector<Warning> pairs_or_scatter(const ResponseTest& test) {
  std::string list;
  for (const identify::DecayMode& mode : test.found.modes) {
    if (!mode.rivals_Hz) continue;
    list += fmt::format("{}{:.6g} Hz (or {:.6g} and {:.6g} Hz)", list.empty() ? "" : ", ", mode.mode.pole.freq_Hz,
                        mode.rivals_Hz->first, mode.rivals_Hz->second);
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
  add(input_warnings(test.record));
  out.push_back(no_force());
  if (!test.possible()) {
    out.push_back(with_remedy({"no_free_decay", "no impact is followed by a free decay", {"accept_hit", "from"}},
                              "record longer after each impact"));
  }
  add(tones(test));
  add(pairs_or_scatter(test));
  add(object_warnings(test.classifications, test.options.classes));
  return ranked(std::move(out));
}

}  // namespace percuss::pipeline
