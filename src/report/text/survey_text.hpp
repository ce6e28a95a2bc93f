#pragma once
#include <string>

#include "pipeline/survey.hpp"
#include "report/text/text_table.hpp"

namespace percuss::report {

/// The survey as text: the test's conditions, the modes with ± and their shapes, the MAC between shapes, how well the
/// modes explain the FRFs, then the warnings. `hits` adds the table of hits. `width` is the terminal's. `write_option`
/// appends the options of warnings; nullptr leaves them out. `warnings` = false leaves out the warnings.
std::string survey_text(const pipeline::Survey& survey, bool hits, std::size_t width,
                        OptionWriter write_option = nullptr, bool warnings = true);

/// Each mode with its order, shape and modal mass, where known.
TextTable survey_modes_table(const pipeline::Survey& survey);

}  // namespace percuss::report
