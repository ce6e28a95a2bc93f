#pragma once
#include <set>
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"

namespace percuss {

/// Parts of an analysis that a report can hold; naming them is the demand that computes them.
enum class Section { hits, frf, coherence, modes, classes };

/// The sections named in a list such as {"hits", "modes"}; UsageError names the known ones.
std::set<Section> parse_sections(const std::vector<std::string>& names);
std::set<Section> all_sections();

struct JsonOptions {
  std::set<Section> sections = all_sections();
  bool trace = false;
  bool per_hit = false;
  const std::vector<Verdict>* verdicts = nullptr;  // of the modes, in place of the analysis' own
  const std::vector<Warning>* warnings = nullptr;
};

/// One of several tests: its run number (or place on the command line) and its analysis.
struct NumberedAnalysis {
  int run = 0;
  const Analysis* analysis = nullptr;
};

/// The document percuss/analysis/1 with the sections asked for, indented, with a line end. Several tests stand in an
/// array "runs". Text that is not UTF-8 (file names) is shown with replacement characters.
std::string analysis_json(const std::vector<NumberedAnalysis>& tests, const JsonOptions& options = {});
std::string analysis_json(const Analysis& analysis, const JsonOptions& options = {});

}  // namespace percuss
