#pragma once
#include <string>

#include "pipeline/survey.hpp"
#include "report/html/page_elements.hpp"

namespace percuss::report {

/// A survey as a page of one file: modes, warnings, shapes in motion on the structure's points and lines, how alike
/// they are (MAC), the mode indicator, FRFs and hits.
std::string survey_page(const pipeline::Survey& survey, const Provenance& provenance);

}  // namespace percuss::report
