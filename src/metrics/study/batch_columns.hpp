#pragma once
#include <string>
#include <vector>

namespace percuss::metrics {

/// The columns of the table that percuss batch merge writes and percuss study reads, in the order of writing; in the
/// rows as JSON they are the keys. "row" says what a row is of, a "record" or a "mode"; the first four are of both.
const std::vector<std::string>& batch_columns();

inline constexpr const char* kBatchSchema = "percuss/batch/1";

}  // namespace percuss::metrics
