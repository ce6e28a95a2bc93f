#pragma once
#include "metrics/protocol/abi.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// JSON: percuss/abi/1 (docs/schema/abi.schema.json). Text: the next step or the verdict, then compressions and tests.
/// Table: both. Charts: performance over the tests, with the limit, and the hoop frequency if it was measured.
CommandReport abi_report(const metrics::AbiLog& log, const metrics::AbiRun& run);

}  // namespace percuss::report
