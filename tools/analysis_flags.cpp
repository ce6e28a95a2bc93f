#include "analysis_flags.hpp"

#include <charconv>
#include <cmath>

#include "core/error.hpp"
#include "number_checks.hpp"

namespace percuss::tools {
namespace {

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
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

Effort effort_of(const std::string& name) {
  for (const Effort effort : {Effort::quick, Effort::standard}) {
    if (name == name_of(effort)) return effort;
  }
  return Effort::best;
}

void add_analysis_flags(CLI::App& command, AnalysisFlags& flags) {
  command.add_option("--band", flags.band, "Frequency band LO:HI in Hz (default: what the hammer excited)")
      ->type_name("LO:HI");
  command
      .add_option(
          "--effort", flags.effort,
          "quick: peaks and local fits; standard: also close pairs and weak modes; best: all modes together, at "
          "the statistical limit")
      ->check(CLI::IsMember({"quick", "standard", "best"}))
      ->capture_default_str();
  command.add_option("--estimator", flags.estimator, "FRF estimator: h1, h2 or hv")
      ->check(CLI::IsMember({"h1", "h2", "hv"}))
      ->capture_default_str();
  command.add_option("--accept-hit", flags.accept_hits, "Use these hits whatever was found")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(counted())
      ->type_name("I,...");
  command.add_option("--reject-hit", flags.reject_hits, "Leave these hits out")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(counted())
      ->type_name("I,...");
  command.add_option("--modes", flags.modes, "Report this many modes, the clearest ones")->check(CLI::Range(1, 1000));
  command.add_option("--start", flags.start_Hz, "Fit modes at these frequencies and no others")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(above_zero())
      ->type_name("HZ,...");
  command.add_option("--trigger", flags.trigger_N, "Force in N that counts as a hit (default: from the noise)")
      ->check(above_zero());
  command.add_option("--pretrigger", flags.pretrigger_s, "Seconds kept before each hit of a long record")
      ->check(not_negative());
  command.add_option("--length", flags.length_s, "Seconds kept of each hit")->check(above_zero());
  command.add_option("--from", flags.from_s, "Use each row from this second on")->check(not_negative());
  command.add_option("--to", flags.to_s, "... and up to this one")->check(above_zero());
  command
      .add_option("--force-window", flags.force_window,
                  "auto: the pulse alone enters the FRF; off: the whole force record")
      ->check(CLI::IsMember({"auto", "off"}))
      ->capture_default_str();
  command
      .add_option("--exponential", flags.exponential_end,
                  "Exponential window falling to this fraction at the end; the damping is corrected exactly")
      ->check(finite())
      ->check(CLI::Range(1e-12, 0.999999));
  command.add_option("--overlay-db", flags.overlay_dB, "Two FRFs this close at a peak count as overlaid")
      ->check(above_zero())
      ->capture_default_str();
  command.add_option("--threads", flags.threads, "Threads to use (default: all; the result is the same)")
      ->check(CLI::Range(0, 1024));
}

AnalysisOptions analysis_options(const AnalysisFlags& flags) {
  AnalysisOptions options;
  if (!flags.band.empty()) options.band_Hz = parse_band(flags.band, "--band");
  options.estimator = flags.estimator == "h2" ? Estimator::h2 : flags.estimator == "hv" ? Estimator::hv : Estimator::h1;
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
  options.modes = {.effort = effort_of(flags.effort), .modes = flags.modes, .start_Hz = flags.start_Hz};
  options.classes.overlay_dB = flags.overlay_dB;
  options.threads = flags.threads;
  return options;
}

}  // namespace percuss::tools
