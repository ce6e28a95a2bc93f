#pragma once
#include "metrics/protocol/abi.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// percuss/abi/1 (docs/schema/abi.schema.json); what comes next or the verdict, then the compressions and the tests,
/// and both as one table; performance over the tests with the limit.
CommandReport abi_report(const metrics::AbiLog& log, const metrics::AbiRun& run);

}  // namespace percuss::report
