#pragma once
#include <cstddef>
#include <string>

#include "metrics/abi.hpp"

namespace percuss {

/// The document percuss/abi/1 (docs/schema/abi.schema.json), indented, with a line end.
std::string abi_json(const AbiLog& log, const AbiRun& run);

/// What an operator reads: what comes next or the verdict, then the compressions and the tests.
std::string abi_text(const AbiLog& log, const AbiRun& run, std::size_t width);

/// The compressions and the tests as one table.
std::string abi_csv(const AbiRun& run);

/// Performance over the tests, with the limit.
std::string abi_svg(const AbiLog& log, const AbiRun& run);

}  // namespace percuss
