#pragma once
#include "cli/output.hpp"
#include "report/html/page_elements.hpp"

namespace percuss::tools {

/// The command line, this process's unless another program runs the command, and the time in UTC (that of
/// SOURCE_DATE_EPOCH where it is set).
report::Provenance provenance_now(const OutputFlags& flags);

/// As a shell would take the word again.
std::string shell_quoted_argument(const std::string& word);

}  // namespace percuss::tools
