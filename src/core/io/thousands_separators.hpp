#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/io/csv_dialect.hpp"

namespace percuss {
inline namespace core {

/// A cell whose number seems to hold thousands separators ("5,040", "19.013,53", "1'250"), among the first 64 lines of
/// the text and the probes (probe_lines()); empty where there is none. The only comma or point of a number may mark
/// decimals instead. With three digits after it, it separates thousands only in two cases: the other numbers of the
/// column are whole and below 1000; or all cells of the column are such numbers in quotes, and commas separate the
/// cells.
std::string cell_with_thousands_separators(std::string_view text, const std::vector<std::string_view>& probes,
                                           const CsvDialect& dialect);

}  // namespace core
}  // namespace percuss
