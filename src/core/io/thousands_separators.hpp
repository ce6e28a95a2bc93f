#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/io/csv_dialect.hpp"

namespace percuss {
inline namespace core {

/// A cell whose number seems to hold thousands separators ("5,040", "19.013,53", "1'250"), among the first 64 lines of
/// the text and the probes; empty where there is none. A comma or point before three digits separates thousands in two
/// cases: the other numbers of the column are whole and below 1000; or all cells of the column are such numbers in
/// quotes, and commas separate the cells. Otherwise it marks decimals.
std::string cell_with_thousands_separators(std::string_view text, const std::vector<std::string_view>& probes,
                                           const CsvDialect& dialect);

}  // namespace core
}  // namespace percuss
