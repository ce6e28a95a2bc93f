#pragma once
#include <string>
#include <vector>

#include "pipeline/survey.hpp"
#include "report/svg/svg_fragment.hpp"

namespace percuss::report {

/// Names of the charts of a survey: shapes, indicator, and the charts of an analysis.
const std::vector<std::string>& survey_chart_names();

/// The chosen charts in the order of survey_chart_names(); charts without data are left out.
std::vector<SvgFragment> survey_charts(const pipeline::Survey& survey, const std::vector<std::string>& names);

}  // namespace percuss::report
