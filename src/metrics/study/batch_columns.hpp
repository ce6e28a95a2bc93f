#pragma once
#include <string>
#include <vector>

namespace percuss::metrics {

/// The columns of a merged batch table, in the order of writing. They are the keys of rows written as JSON. The column
/// "row" is "record" or "mode"; both kinds of row have the first four columns.
const std::vector<std::string>& batch_columns();

inline constexpr const char* kBatchSchema = "percuss/batch/1";

}  // namespace percuss::metrics
