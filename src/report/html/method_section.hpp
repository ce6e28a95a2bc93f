#pragma once
#include <string>

#include "pipeline/analysis.hpp"
#include "report/html/title_block.hpp"
#include "report/text/method_text.hpp"

namespace percuss::report {

/// The section "Method": how the results were made, in sentences, and the channels as a table.
std::string method_section(const pipeline::Analysis& analysis, const MethodScope& scope);

/// The title block with the facts that the files state: the date of the test.
TitleBlock with_file_facts(TitleBlock block, const pipeline::Analysis& analysis);

}  // namespace percuss::report
