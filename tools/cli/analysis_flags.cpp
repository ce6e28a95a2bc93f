#include "cli/analysis_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace percuss::tools {
namespace {

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<double> without_duplicates(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

}  // namespace

std::pair<double, double> parse_band(const std::string& text, const char* option) {
  const auto colon = text.find(':');
  const auto low = number(std::string_view(text).substr(0, colon));
  const auto high = colon == std::string::npos ? std::nullopt : number(std::string_view(text).substr(colon + 1));
  if (low && high && *low >= 0 && *low < *high) return {*low, *high};
  throw UsageError(std::string(option) + " cannot be '" + text + "'",
                   "give two frequencies in Hz, the lower first: LO:HI, as 60:3200");
}

identify::Effort effort_of(const std::string& name) {
  for (const identify::Effort effort : {identify::Effort::quick, identify::Effort::standard}) {
    if (name == name_of(effort)) return effort;
  }
  return identify::Effort::best;
}

void add_analysis_options(Command& command, AnalysisFlags& flags) {
  const std::string others = command.heading(kAnalysisHeading);
  command.value("--band", flags.band, "Frequency band in Hz, as 60:3200 (default: what the hammer excited)")
      .type("LO:HI");
  command
      .value("--effort", flags.effort,
             "quick: modes that show a peak, each over its own lines; standard: also those that show none; best: all "
             "modes together, at the statistical limit")
      .one_of({"quick", "standard", "best"})
      .show_default();
  command.value("--estimator", flags.estimator, "FRF estimator: h1, h2 or hv")
      .one_of({"h1", "h2", "hv"})
      .show_default();
  command
      .list("--accept-hit", flags.accept_hits,
            "Use these hits, whatever was found against them; numbers as in the table of hits")
      .type("I,...");
  command.list("--reject-hit", flags.reject_hits, "Leave these hits out; numbers as in the table of hits")
      .type("I,...");
  command.value("--modes", flags.modes, "Report this many modes, the clearest ones").within(1, 1000);
  command.list("--start", flags.start_Hz, "Fit modes near these frequencies and no others").above_zero().type("HZ,...");
  command.value("--trigger", flags.trigger_N, "Force that counts as a hit (default: from the noise)")
      .above_zero()
      .type("NEWTON");
  command.value("--pretrigger", flags.pretrigger_s, "Time kept before each hit of a long record")
      .not_negative()
      .type("S");
  command.value("--length", flags.length_s, "Time kept of each hit").above_zero().type("S");
  command.value("--from", flags.from_s, "Use each row from this time on").not_negative().type("S");
  command.value("--to", flags.to_s, "Use each row up to this time").above_zero().type("S");
  command
      .value("--force-window", flags.force_window, "auto: the pulse alone enters the FRF; off: the whole force record")
      .one_of({"auto", "off"})
      .show_default();
  command
      .value("--exponential", flags.exponential_end,
             "Exponential window that falls to this fraction at the end, as 0.01; the damping is corrected exactly")
      .within(1e-12, 0.999999)
      .type("FRACTION");
  command
      .value("--overlay-db", flags.overlay_dB, "Two FRFs that differ by no more than this at a peak count as overlaid")
      .above_zero()
      .type("DB")
      .show_default();
  command.heading(others);
}

void add_analysis_flags(Command& command, AnalysisFlags& flags) {
  add_analysis_options(command, flags);
  const std::string others = command.heading(kAnalysisHeading);
  command.value("--threads", flags.threads, "Threads to use (default: all; the result is the same)").within(0, 1024);
  command.heading(others);
}

namespace {

// A start outside the band would be fitted and then not reported.
void require_within_band(const std::optional<std::pair<double, double>>& band_Hz, const std::vector<double>& start_Hz) {
  for (const double start : start_Hz) {
    if (band_Hz && (start < band_Hz->first || start > band_Hz->second)) {
      throw UsageError(
          fmt::format("--start {:g} lies outside --band {:g}:{:g}", start, band_Hz->first, band_Hz->second),
          "widen the band or leave it out");
    }
  }
}

}  // namespace

pipeline::AnalysisOptions analysis_options(const AnalysisFlags& flags) {
  pipeline::AnalysisOptions options;
  if (!flags.band.empty()) options.band_Hz = parse_band(flags.band, "--band");
  options.estimator = flags.estimator == "h2"   ? frf::Estimator::h2
                      : flags.estimator == "hv" ? frf::Estimator::hv
                                                : frf::Estimator::h1;
  options.hits = {.trigger_N = flags.trigger_N,
                  .pretrigger_s = flags.pretrigger_s,
                  .length_s = flags.length_s,
                  .from_s = flags.from_s,
                  .to_s = flags.to_s,
                  .gate_force = flags.force_window == "auto"};
  if (flags.to_s && *flags.to_s <= flags.from_s)
    throw UsageError("--to is not after --from", "give seconds from each row's beginning");
  options.accept_hits = flags.accept_hits;
  options.reject_hits = flags.reject_hits;
  for (const std::size_t hit : flags.accept_hits) {
    for (const std::size_t other : flags.reject_hits) {
      if (hit == other)
        throw UsageError("hit " + std::to_string(hit) + " is both accepted and rejected", "name it once");
    }
  }
  options.exponential_end = flags.exponential_end;
  require_within_band(options.band_Hz, flags.start_Hz);
  options.modes = {
      .effort = effort_of(flags.effort), .modes = flags.modes, .start_Hz = without_duplicates(flags.start_Hz)};
  options.classes.overlay_dB = flags.overlay_dB;
  options.threads = flags.threads;
  return options;
}

}  // namespace percuss::tools
