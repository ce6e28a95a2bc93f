#pragma once
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"
#include "pipeline/impact_test.hpp"
#include "pipeline/survey_modes.hpp"
#include "report/json/bat_label.hpp"
#include "report/json/json_document.hpp"
#include "report/text/report_sections.hpp"

namespace percuss::report {

struct JsonOptions {
  std::set<ReportSection> sections = default_sections();
  bool trace = false;
  bool explain = false;  // the skipped work
  bool per_hit = false;
  bool stabilisation = false;  // computes the diagram
  // In place of the analysis's own:
  const std::vector<identify::ModeClassification>* classifications = nullptr;
  const std::vector<pipeline::Warning>* warnings = nullptr;
  const pipeline::SurveyModes* modes = nullptr;
  std::function<std::string(std::size_t mode)> shape;  // value of each mode's member "shape", as JSON text
  std::optional<BatLabel> bat;
  const pipeline::ImpactTest* deflection = nullptr;  // for a single test
};

/// One of several tests: its analysis and its run number, or its place among the files.
struct NumberedAnalysis {
  int run = 0;
  const pipeline::Analysis* analysis = nullptr;
};

/// The document percuss/analysis/1 with the chosen sections, indented, with a line end. Several tests form an array
/// "runs". Bytes that are not UTF-8 (in file names) become replacement characters.
std::string analysis_json(const std::vector<NumberedAnalysis>& tests, const JsonOptions& options = {});
std::string analysis_json(const pipeline::Analysis& analysis, const JsonOptions& options = {});

/// The document that analysis_json writes, for documents that add to it. `analysis` and the objects that `options`
/// refers to must outlive it.
JsonDocument analysis_document(const pipeline::Analysis& analysis, const JsonOptions& options);

}  // namespace percuss::report
