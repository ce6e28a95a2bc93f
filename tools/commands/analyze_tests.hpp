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
#include "report/text/report_sections.hpp"

namespace percuss::tools {

struct AnalyzeFlags {
  ReadFlags read;
  AnalysisFlags analysis;
  OutputFlags output;
  std::vector<std::string> only;
  bool trace = false;
  bool explain = false;
  bool per_hit = false;
  bool stabilisation = false;
  std::vector<std::string> pictures{"magnitude", "phase", "coherence"};
  std::vector<std::string> compared;
  std::string bat_id;
  std::vector<std::string> bat;  // key=value
};

/// One test of the command line: all of the files together, or each on its own, or each run of one file.
struct Test {
  int run = 0;
  std::unique_ptr<pipeline::Analysis> analysis;
  std::optional<pipeline::ImpactTest> deflection{};
};

/// What the files hold as the flags have it. errors  as open_measurements
std::vector<Test> tests_of(const AnalyzeFlags& flags);

/// What the sections need of several tests, one beside the other; what fails will fail again where the report asks for
/// it, in turn.
void compute(const std::vector<Test>& tests, const std::set<report::ReportSection>& sections);

}  // namespace percuss::tools
