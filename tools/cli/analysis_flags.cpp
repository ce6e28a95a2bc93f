#include "cli/analysis_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "cli/hit_list.hpp"
#include "cli/option_error.hpp"
#include "cli/option_units.hpp"
#include "core/error.hpp"
#include "core/io/parse_number.hpp"
#include "pipeline/hits/hit_grading.hpp"

namespace percuss::tools {
namespace {

std::optional<double> number(std::string_view text) {
  const ParsedNumber parsed = parse_number(text, false);
  return parsed.problem == NumberProblem::none ? std::optional(parsed.value) : std::nullopt;
}

// "3200", "3200Hz" or "3.2kHz" in Hz.
std::optional<double> frequency_Hz(std::string_view text) { return number(in_option_unit(std::string(text), "HZ")); }

std::vector<double> sorted_distinct(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

void add_band_options(Command& command, AnalysisFlags& flags) {
  command
      .value("--band", flags.band,
             "Analyse this frequency band in Hz, such as 60:3200 (default: from 1 % to 100 % of the highest "
             "frequency that the hammer excites)")
      .type("LO:HI");
  command
      .value("--effort", flags.effort,
             "Choose the effort. quick: fit modes with a peak, each over its own spectral lines; standard: also modes "
             "without a peak; best: all modes together, as precisely as the noise permits")
      .one_of({"quick", "standard", "best"})
      .show_default();
  command.value("--estimator", flags.estimator, "Estimate FRFs with h1, h2 or hv")
      .one_of({"h1", "h2", "hv"})
      .show_default();
}

void add_hit_choice_options(Command& command, AnalysisFlags& flags) {
  command
      .list(
          "--accept-hit", flags.accept_hits,
          "Accept these hits despite their findings: numbers as in the table of hits, ranges, or all; such as 1-5,8. A "
          "hit without a pulse of the force gives no FRF and stays rejected")
      .type("I,...")
      .add_check(kHitsRequirement, names_hits);
  command.list("--reject-hit", flags.reject_hits, "Reject these hits, written as for --accept-hit")
      .type("I,...")
      .add_check(kHitsRequirement, names_hits);
}

void add_mode_choice_options(Command& command, AnalysisFlags& flags) {
  command.value("--modes", flags.modes, "Report this many modes, the clearest ones").within(1, 1000);
  command.list("--start", flags.start_Hz, "List modes near these frequencies and no others")
      .above_zero()
      .type("HZ,...");
}

void add_hit_detection_options(Command& command, AnalysisFlags& flags) {
  command.value("--trigger", flags.trigger_N, "Detect a hit above this force (default: from the noise)")
      .above_zero()
      .type("NEWTON");
  command.value("--pretrigger", flags.pretrigger_s, "Keep this time before the peak of each hit of a long record")
      .not_negative()
      .type("S");
  command.value("--length", flags.length_s, "Keep this time of each hit, pre-trigger included").above_zero().type("S");
  command.value("--from", flags.from_s, "Use each row from this time on").not_negative().type("S");
  command.value("--to", flags.to_s, "Use each row up to this time").above_zero().type("S");
}

void add_window_options(Command& command, AnalysisFlags& flags) {
  command
      .value("--force-window", flags.force_window,
             "Window the force. auto: only the pulse enters the FRF; off: the whole force record")
      .one_of({"auto", "off"})
      .show_default();
  command
      .value("--exponential", flags.exponential_end,
             "Apply an exponential window that falls to this fraction at the end of each hit, such as 0.01; damping is "
             "corrected exactly. For FRFs: the window with which they were computed")
      .within(1e-12, 0.999999)
      .type("FRACTION");
}

}  // namespace

std::pair<double, double> parse_band(const std::string& text, const OptionId& option) {
  const auto colon = text.find(':');
  const auto low = frequency_Hz(std::string_view(text).substr(0, colon));
  const auto high = colon == std::string::npos ? std::nullopt : frequency_Hz(std::string_view(text).substr(colon + 1));
  if (low && high && *low >= 0 && *low < *high) return {*low, *high};
  throw OptionError::wrong_value(option, text,
                                 "give two frequencies in Hz, the lower first: LO:HI, such as 60:3200 or 60:3.2kHz");
}

identify::Effort effort_of(const std::string& name) {
  for (const identify::Effort effort : {identify::Effort::quick, identify::Effort::standard}) {
    if (name == name_of(effort)) return effort;
  }
  return identify::Effort::best;
}

void add_analysis_options(Command& command, AnalysisFlags& flags) {
  const std::string previous = command.heading(kAnalysisHeading);
  add_band_options(command, flags);
  add_hit_choice_options(command, flags);
  add_mode_choice_options(command, flags);
  add_hit_detection_options(command, flags);
  add_window_options(command, flags);
  command
      .value("--delay", flags.delay,
             "Remove the delay of each accelerometer against the force. auto: estimate it from the phases of the "
             "modes; off: only warn about it; or give it in seconds, one for all or one per channel, negative if the "
             "channel is early")
      .type("auto|off|S,...")
      .show_default();
  command
      .value("--overlay-db", flags.overlay_dB,
             "Treat two FRFs as overlaid if they differ by at most this much at a peak")
      .above_zero()
      .type("DB")
      .show_default();
  add_object_option(command, flags.object);
  command.heading(previous);
}

void add_analysis_flags(Command& command, AnalysisFlags& flags) {
  add_analysis_options(command, flags);
  const std::string previous = command.heading(kAnalysisHeading);
  command.value("--threads", flags.threads, "Use this many threads (default: all; the result is the same)")
      .within(0, 1024);
  add_budget_option(command, flags.budget);
  command.heading(previous);
}

void add_budget_option(Command& command, std::vector<double>& budget) {
  command
      .list(
          "--budget", budget,
          "Stop an analysis that takes more than this time in seconds or memory in GB (default: 120 s plus 2 s per MB "
          "of input; 2.1 GB plus 16 times the input)")
      .above_zero()
      .type("S[,GB]");
}

std::optional<Budget> budget_of(const std::vector<double>& values) {
  constexpr double kGigabyte = 1e9, kMaxGigabytes = 1e9;
  if (values.empty()) return std::nullopt;
  if (values.size() > 2) {
    throw OptionError::wrong_value("budget", fmt::format("{:g}", fmt::join(values, ",")),
                                   "give a time in s, or a time and a memory in GB");
  }
  Budget budget{.time_s = values[0]};
  if (values.size() == 2)
    budget.memory_bytes = static_cast<std::uint64_t>(std::min(values[1], kMaxGigabytes) * kGigabyte);
  return budget;
}

namespace {

pipeline::DelayCorrection parse_delay(const std::string& text) {
  if (text == "auto") return {.automatic = true, .delay_s = {}};
  pipeline::DelayCorrection out;
  if (text == "off") return out;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find(',', from), text.size());
    const auto delay_s = number(std::string_view(text).substr(from, end - from));
    if (!delay_s)
      throw OptionError::wrong_value("delay", text, "give auto, off, or delays in seconds such as 20e-6,40e-6");
    out.delay_s.push_back(*delay_s);
    from = end + 1;
  }
  return out;
}

void require_distinct(const std::vector<std::size_t>& accepted, const std::vector<std::size_t>& rejected) {
  const std::set<std::size_t> first(accepted.begin(), accepted.end());
  for (const std::size_t hit : rejected) {
    if (!first.contains(hit)) continue;
    const std::string which = hit == pipeline::kEveryHit ? "all hits" : fmt::format("hit {}", hit + 1);
    throw OptionError({"accept_hit", "reject_hit"}, "both name " + which, "name it once");
  }
}

// A mode outside the band would be fitted but not reported.
void require_within_band(const std::optional<std::pair<double, double>>& band_Hz, const std::vector<double>& start_Hz) {
  for (const double start : start_Hz) {
    if (band_Hz && (start < band_Hz->first || start > band_Hz->second)) {
      throw OptionError::wrong_value(
          "start", fmt::format("{:g}", start), "widen the band or omit it",
          fmt::format("it lies outside the band {:g}:{:g} Hz", band_Hz->first, band_Hz->second), {"band"});
    }
  }
}

}  // namespace

void add_object_option(Command& command, std::string& object) {
  command
      .value("--object", object,
             "State what was struck. Bending and hoop are judged on a tube only; modes of other objects are numbered. "
             "auto: a tube if angles are given, or if the modes fit two accelerometers at 0° and 90°")
      .one_of({"auto", "tube", "other"})
      .show_default();
}

identify::ObjectKind object_kind_of(const std::string& name) {
  if (name == "tube") return identify::ObjectKind::tube;
  return name == "other" ? identify::ObjectKind::other : identify::ObjectKind::automatic;
}

pipeline::AnalysisOptions analysis_options(const AnalysisFlags& flags) {
  pipeline::AnalysisOptions options;
  if (!flags.band.empty()) options.band_Hz = parse_band(flags.band, "band");
  options.estimator = flags.estimator == "h2"   ? frf::Estimator::h2
                      : flags.estimator == "hv" ? frf::Estimator::hv
                                                : frf::Estimator::h1;
  options.hits = {.trigger_N = flags.trigger_N,
                  .pretrigger_s = flags.pretrigger_s,
                  .length_s = flags.length_s,
                  .from_s = flags.from_s,
                  .to_s = flags.to_s,
                  .gate_force = flags.force_window == "auto"};
  if (flags.to_s && *flags.to_s <= flags.from_s) {
    throw OptionError({"to"}, "is not later than the start of the time selection",
                      "give a later time, in seconds from the start of each row", {"from"});
  }
  options.accept_hits = parse_hits("accept_hit", flags.accept_hits);
  options.reject_hits = parse_hits("reject_hit", flags.reject_hits);
  require_distinct(options.accept_hits, options.reject_hits);
  options.exponential_end = flags.exponential_end;
  options.delays = parse_delay(flags.delay);
  require_within_band(options.band_Hz, flags.start_Hz);
  options.modes = {
      .effort = effort_of(flags.effort), .modes = flags.modes, .start_Hz = sorted_distinct(flags.start_Hz)};
  options.classes.overlay_dB = flags.overlay_dB;
  options.classes.object = object_kind_of(flags.object);
  options.threads = flags.threads;
  options.budget = budget_of(flags.budget);
  return options;
}

}  // namespace percuss::tools
