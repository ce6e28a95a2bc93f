#pragma once
#include <string>
#include <vector>

#include "pipeline/survey.hpp"
#include "report/svg/svg_fragment.hpp"

namespace percuss::report {

/// Names of the pictures of a survey: shapes, indicator, and those of an analysis.
const std::vector<std::string>& survey_chart_names();

/// The pictures asked for, in that order; those there is nothing for are left out.
std::vector<SvgFragment> survey_charts(const pipeline::Survey& survey, const std::vector<std::string>& names);

}  // namespace percuss::report
