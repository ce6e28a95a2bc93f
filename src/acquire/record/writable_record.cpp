#include "acquire/record/writable_record.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace percuss::acquire {

void require_contents(const Record& record, const std::string& path) {
  if (record.rows.empty()) throw InputError("no hits to write", path, "keep at least one");
  if (record.accel.empty()) throw InputError("no acceleration to write", path, "keep at least one channel");
}

void require_equal_lengths(const Record& record, const std::string& path) {
  require_contents(record, path);
  const std::size_t samples = record.rows.front().samples;
  for (const RowInfo& row : record.rows) {
    if (row.samples == samples) continue;
    throw InputError(fmt::format("hits differ in length: {} and {} samples", samples, row.samples), path,
                     "write them as CSV or UFF, or each length to a file of its own");
  }
}

}  // namespace percuss::acquire
