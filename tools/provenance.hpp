#pragma once
#include "report/page_parts.hpp"

namespace percuss::tools {

/// This process's command line and the time in UTC (that of SOURCE_DATE_EPOCH where it is set).
Provenance provenance_now();

}  // namespace percuss::tools
