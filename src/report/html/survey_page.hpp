#pragma once
#include <string>

#include "pipeline/survey.hpp"
#include "report/html/page_elements.hpp"

namespace percuss::report {

/// The survey as a self-contained page: modes, warnings, animated shapes on the structure's points and lines, their
/// MAC, the mode indicator, FRFs and hits.
std::string survey_page(const pipeline::Survey& survey, const Provenance& provenance);

}  // namespace percuss::report
