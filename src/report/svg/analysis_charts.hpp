#pragma once
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"
#include "report/svg/svg_fragment.hpp"

namespace percuss::report {

/// Names of the charts of an analysis: magnitude, phase, coherence, force, response, spectrum, decay, stabilisation,
/// movement.
const std::vector<std::string>& analysis_chart_names();

/// The chosen charts in the order of analysis_chart_names(); charts without data are left out. `modes`: in
/// place of the analysis's own.
std::vector<SvgFragment> analysis_charts(const pipeline::Analysis& analysis,
                                         const std::vector<identify::ModeClassification>& classifications,
                                         const std::vector<std::string>& names,
                                         const std::vector<identify::Mode>* modes = nullptr);

}  // namespace percuss::report
