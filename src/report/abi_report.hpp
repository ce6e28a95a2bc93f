#pragma once
#include "metrics/protocol/abi.hpp"
#include "report/command_report.hpp"

namespace percuss {

/// percuss/abi/1 (docs/schema/abi.schema.json); what comes next or the verdict, then the compressions and the tests,
/// and both as one table; performance over the tests with the limit.
CommandReport abi_report(const AbiLog& log, const AbiRun& run);

}  // namespace percuss
