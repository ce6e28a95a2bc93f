#pragma once
#include <set>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "pipeline/analysis.hpp"
#include "report/text/report_sections.hpp"

namespace percuss::report {

struct TextOptions {
  std::set<ReportSection> sections = default_sections();
  std::size_t width = 100;  // of the terminal
  bool per_hit = false;
  bool warnings = true;
  bool sketch = false;                  // a plot of the FRFs in characters
  OptionWriter write_option = nullptr;  // appends the options of warnings; nullptr leaves them out
};

/// The sentence in place of the FRFs and modes if none of `hits` can be used.
Message no_usable_hit(const std::vector<pipeline::AnalysedHit>& hits);

/// The analysis as text: one line with the test's conditions, the hits, the modes with ±, then the warnings.
std::string analysis_text(const pipeline::Analysis& analysis, const TextOptions& options = {});

}  // namespace percuss::report
