#include "pipeline/response/missing_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "acquire/hits/time_selection.hpp"
#include "pipeline/warnings/mode_warnings.hpp"

namespace percuss::pipeline {
namespace {

bool is_constant(const ResponseTest& test, std::size_t channel) {
  constexpr std::size_t kPiece = 4096;  // samples
  const acquire::Record& record = test.record;
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    const acquire::SampleRange range = acquire::select_time_range(record, row, test.options.hits);
    double first = 0;
    for (std::size_t at = range.first; at < range.last; at += kPiece) {
      std::vector<double> samples(std::min(kPiece, range.last - at));
      record.read_accel_mps2(row, channel, at, samples);
      if (at == range.first) first = samples.front();
      if (std::any_of(samples.begin(), samples.end(), [&](double value) { return value != first; })) return false;
    }
  }
  return true;
}

std::vector<std::size_t> constant_channels(const ResponseTest& test) {
  std::vector<std::size_t> out;
  for (std::size_t c = 0; c < test.record.accel.size(); ++c) {
    if (is_constant(test, c)) out.push_back(c);
  }
  return out;
}

std::vector<Warning> dead_channels(const ResponseTest& test, const std::vector<std::size_t>& constant) {
  std::vector<Warning> out;
  for (const std::size_t c : constant) {
    const std::string message = fmt::format("{} is constant: the {} or its cable is dead, or the recorder was muted",
                                            one_line(test.record.accel[c].name, kMaxNameBytes),
                                            is_pressure(test.record.accel[c]) ? "microphone" : "sensor or microphone");
    const bool others = constant.size() < test.record.accel.size();
    out.push_back(with_remedy(
        {"dead_channel", message, others ? std::vector<OptionId>{"accel_channel"} : std::vector<OptionId>()},
        others ? "check them, or choose the other channels" : "check them, and record again"));
  }
  return out;
}

// no_modes, for a test whose modes were fitted.
std::vector<Warning> missing_modes(const ResponseTest& test) {
  if (test.no_impact) {
    return {with_remedy({"no_modes", "no impact was found: no signal rises above the noise"},
                        "check the sensor or microphone and its gain, and strike harder or record nearer")};
  }
  if (!test.fitted || !test.possible()) return {};
  if (count_impacts(test) == 0) {
    return {with_remedy({"no_modes",
                         fmt::format("no impact was found, and no mode from {:.4g} to {:.4g} Hz", test.band_Hz.first,
                                     test.band_Hz.second),
                         {"band"}},
                        "check the band and the record")};
  }
  std::vector<identify::Mode> modes;
  for (const auto* list : {&test.found.modes, &test.found.tones}) {
    for (const identify::DecayMode& one : *list) modes.push_back(one.mode);
  }
  std::vector<Warning> out = no_modes_warnings(modes, test.band_Hz, !test.options.modes.start_Hz.empty());
  if (!out.empty() || !test.found.modes.empty()) return out;
  return {with_remedy({"no_modes",
                       fmt::format("no mode was found from {:.4g} to {:.4g} Hz: signals rise above the noise there, "
                                   "but do not decay",
                                   test.band_Hz.first, test.band_Hz.second),
                       {"band"}},
                      "check the band, the sensors and the hits")};
}

}  // namespace

std::vector<Warning> missing_result_warnings(const ResponseTest& test) {
  const std::vector<std::size_t> constant = constant_channels(test);
  std::vector<Warning> out = dead_channels(test, constant);
  std::vector<Warning> modes = missing_modes(test);
  out.insert(out.end(), std::make_move_iterator(modes.begin()), std::make_move_iterator(modes.end()));
  if (!test.possible() && !test.no_impact && constant.size() < test.record.accel.size()) {
    const bool acceptable = std::any_of(test.hits.begin(), test.hits.end(),
                                        [](const ResponseHit& hit) { return !hit.accepted && can_be_accepted(hit); });
    Warning warning{"no_free_decay", "no impact is followed by a free decay", {"from"}};
    if (acceptable) warning.options = {"accept_hit", "from"};
    out.push_back(with_remedy(std::move(warning), "record longer after each impact"));
  }
  return out;
}

Message why_impossible(const ResponseTest& test) {
  for (const char* const code : {"no_free_decay", "no_modes", "dead_channel"}) {
    const auto found = std::find_if(test.warnings.begin(), test.warnings.end(),
                                    [&](const Warning& warning) { return warning.code == code; });
    if (found != test.warnings.end()) return {found->message, found->options};
  }
  return {};
}

}  // namespace percuss::pipeline
