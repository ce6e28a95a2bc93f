#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/option_error.hpp"
#include "core/error.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::tools {

/// The analysis options as typed, shared by analyze, frf, nodes, survey, deflect and batch plan.
struct AnalysisFlags {
  std::string band;
  std::string effort = "best";
  std::string estimator = "h1";
  std::vector<std::string> accept_hits, reject_hits;  // "1-5", "8", "all"
  std::optional<std::size_t> modes;
  std::vector<double> start_Hz;
  std::optional<double> trigger_N, pretrigger_s, length_s, to_s;
  double from_s = 0;
  std::string force_window = "auto";
  double exponential_end = 0;
  std::string delay = "off";  // auto, off or seconds
  double overlay_dB = 1;
  std::string object = "auto";
  std::size_t threads = 0;
  std::vector<double> budget;  // time in s, memory in GB
};

void add_analysis_flags(Command& command, AnalysisFlags& flags);
/// The options that change the result: all but --threads and --budget.
void add_analysis_options(Command& command, AnalysisFlags& flags);
void add_object_option(Command& command, std::string& object);
void add_budget_option(Command& command, std::vector<double>& budget);
/// The value of --budget. Throws OptionError.
std::optional<Budget> budget_of(const std::vector<double>& values);
inline constexpr const char* kAnalysisHeading = "Analysis";

/// Throws UsageError for contradictory values.
pipeline::AnalysisOptions analysis_options(const AnalysisFlags& flags);

/// The value of --object.
identify::ObjectKind object_kind_of(const std::string& name);

/// Reads "LO:HI" in Hz, the value of `option`. Throws OptionError.
std::pair<double, double> parse_band(const std::string& text, const OptionId& option);

}  // namespace percuss::tools
