#pragma once
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"
#include "pipeline/impact_test.hpp"
#include "report/json/json_document.hpp"
#include "report/text/report_sections.hpp"

namespace percuss::report {

/// The bat that a test is of: its id and what else is known of it, by key; values that are numbers stand as such.
struct BatLabel {
  std::string id;
  std::map<std::string, std::string> properties;
};

struct JsonOptions {
  std::set<ReportSection> sections = default_sections();
  bool trace = false;
  bool explain = false;  // what was skipped
  bool per_hit = false;
  bool stabilisation = false;  // the diagram: the demand that computes it
  const std::vector<identify::ModeClassification>* classifications =
      nullptr;  // of the modes, in place of the analysis' own
  const std::vector<pipeline::Warning>* warnings = nullptr;
  std::function<std::string(std::size_t mode)> shape;  // a member of each mode, as JSON text
  std::optional<BatLabel> bat;
  const pipeline::ImpactTest* deflection = nullptr;  // of the one test that there is
};

/// One of several tests: its run number (or place on the command line) and its analysis.
struct NumberedAnalysis {
  int run = 0;
  const pipeline::Analysis* analysis = nullptr;
};

/// The document percuss/analysis/1 with the sections asked for, indented, with a line end. Several tests stand in an
/// array "runs". Text that is not UTF-8 (file names) is shown with replacement characters.
std::string analysis_json(const std::vector<NumberedAnalysis>& tests, const JsonOptions& options = {});
std::string analysis_json(const pipeline::Analysis& analysis, const JsonOptions& options = {});

/// What analysis_json writes out, for documents that add to it; `analysis` and what `options` refers to must outlive
/// it.
JsonDocument analysis_document(const pipeline::Analysis& analysis, const JsonOptions& options);

}  // namespace percuss::report
