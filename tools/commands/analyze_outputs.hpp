#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "commands/analyze_tests.hpp"
#include "commands/bat_label.hpp"
#include "report/html/command_report.hpp"
#include "report/text/analysis_text.hpp"

namespace percuss::tools {

/// The results of analyze. A host (a program that calls the command, cli/host.hpp) keeps them to compute or save more
/// later.
struct AnalyzeResults {
  AnalyzeFlags flags;
  std::vector<Test> tests;
  std::set<report::ReportSection> sections;
  std::optional<report::BatLabel> bat;
  std::string document;
  std::optional<report::CommandReport> comparison;
};

/// The JSON document of the tests.
std::string document_of_tests(const AnalyzeResults& results);

/// Checks the output paths. Throws as check_outputs.
void check_analyze_outputs(const AnalyzeFlags& flags);

/// Whether the path names a table of modes, not of FRFs: "modes.csv", "NAME.modes.csv", "NAME-modes.csv".
bool is_csv_of_modes(const std::string& path);

/// Whether all outputs can hold several tests: documents and tables of modes.
bool holds_several_tests(const AnalyzeFlags& flags);

/// Rejects, before anything is computed, outputs and sections that allow only one test. Throws UsageError.
void require_one_test(const AnalyzeFlags& flags, const std::set<report::ReportSection>& sections, std::size_t tests);

/// The text for a terminal. `sections` and `per_hit` of `options` are ignored: the results state them.
std::string text_of(const AnalyzeResults& results, report::TextOptions options);

/// Writes all output files of the flags.
void write_outputs(const AnalyzeFlags& flags, const AnalyzeResults& results);

/// Gives the results to the host.
void give_to_host(const OutputFlags& output, const std::shared_ptr<const AnalyzeResults>& results);

}  // namespace percuss::tools
