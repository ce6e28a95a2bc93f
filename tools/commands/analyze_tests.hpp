#pragma once
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/analysis_flags.hpp"
#include "cli/open_files.hpp"
#include "cli/output.hpp"
#include "pipeline/impact_test.hpp"
#include "report/html/command_report.hpp"
#include "report/text/report_sections.hpp"

namespace percuss::tools {

struct AnalyzeFlags {
  ReadFlags read;
  AnalysisFlags analysis;
  OutputFlags output;
  std::vector<std::string> frf_paths, modes_paths;  // --frf, --modes-file
  std::vector<std::string> only;
  bool trace = false;
  bool explain = false;
  bool per_hit = false;
  bool stabilisation = false;
  std::vector<std::string> pictures{"magnitude", "phase", "coherence"};
  std::vector<std::string> compared;
  std::string bat_id;
  std::vector<std::string> bat;  // KEY=VALUE
};

/// One test of the command line: all files together, one file, or one run of a file.
struct Test {
  int run = 0;
  std::shared_ptr<const pipeline::Analysis> analysis;
  std::optional<pipeline::ImpactTest> deflection{};
};

/// errors  InputError: files that were joined without a stated grouping, and whose FRFs disagree
void require_agreeing_files(const ReadFlags& read, const pipeline::Analysis& analysis);

/// The tests in the opened files, grouped by the flags.
std::vector<Test> tests_of(const AnalyzeFlags& flags, Measurements opened);

/// Computes the sections of several tests in parallel. It ignores errors, which occur again when the report reads the
/// results.
void compute(const std::vector<Test>& tests, const std::set<report::ReportSection>& sections);

/// Compares the document of this command, called `name`, with the documents of --compare.
report::CommandReport comparison_of(const AnalyzeFlags& flags, const std::string& document, const std::string& name);

}  // namespace percuss::tools
