#pragma once
#include <set>
#include <string>

#include "pipeline/analysis.hpp"
#include "report/text/report_sections.hpp"

namespace percuss::report {

struct TextOptions {
  std::set<ReportSection> sections = default_sections();
  std::size_t width = 100;  // of the terminal
  bool per_hit = false;
  bool warnings = true;
  bool sketch = false;  // a drawing of the FRFs in characters
};

/// What is said of a test without FRFs and modes.
inline constexpr const char* kNoUsableHit = "no hit can be used: no FRF, no modes (--accept-hit overrules a rejection)";

/// The analysis as a person reads it: one line of what was measured, the hits, the modes with ±, then warnings in
/// words.
std::string analysis_text(const pipeline::Analysis& analysis, const TextOptions& options = {});

}  // namespace percuss::report
