#pragma once
#include "cli/output.hpp"
#include "report/html/page_elements.hpp"

namespace percuss::tools {

/// The command line of this process or of the host, and the time in UTC (SOURCE_DATE_EPOCH if it is set).
report::Provenance provenance_now(const OutputFlags& flags);

/// The same, with the instruments of the channel set-up in the title block.
report::Provenance provenance_now(const OutputFlags& flags, const std::string& setup_path);

}  // namespace percuss::tools
