#pragma once
#include <string>

#include "pipeline/survey.hpp"
#include "report/text/text_table.hpp"

namespace percuss::report {

/// A survey as a person reads it: what was measured, the modes with ± and what their shapes are, how alike shapes are
/// and how well the modes explain the FRFs, then warnings in words. `hits` adds the table of hits. `width` of the
/// terminal.
std::string survey_text(const pipeline::Survey& survey, bool hits, std::size_t width);

/// Every mode with its order, shape and modal mass as far as they are known.
TextTable survey_modes_table(const pipeline::Survey& survey);

}  // namespace percuss::report
