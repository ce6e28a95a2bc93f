#include "acquire/formats/text/csv_layout.hpp"

#include <fmt/format.h>

#include "acquire/formats/text/text_check.hpp"
#include "core/error.hpp"
#include "core/io/thousands_separators.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kMaxColumns = 4096;

}  // namespace

CsvLayout layout_of_text(const FileBytes& bytes, CsvContent content) {
  const std::string file = input_name(bytes.path);
  const std::string_view text = without_byte_order_mark(bytes.view());
  const std::size_t mark_bytes = bytes.view().size() - text.size();
  require_text(text.substr(0, std::size_t{1} << 16U), file);
  CsvLayout layout;
  const char line_end = find_line_end(text);
  require_short_lines(text, line_end, file);
  const auto probes = probe_lines(text, line_end);
  layout.dialect = find_dialect(probes, line_end);
  if (has_two_kinds_of_comma(text, probes, layout.dialect)) {
    throw InputError("commas separate the cells and mark decimals", file,
                     "save it with semicolons or tabs between the cells, or with decimal points");
  }
  const std::string grouped = cell_with_thousands_separators(text, probes, layout.dialect);
  if (!grouped.empty()) {
    throw InputError(fmt::format("numbers hold thousands separators (\"{}\")", one_line(to_utf8(grouped), 40)), file,
                     "save it without them");
  }
  layout.number_columns = find_number_columns(probes, layout.dialect);
  if (!layout.number_columns.empty() && layout.number_columns.back() >= kMaxColumns - 1)
    throw InputError("more than 4095 columns", file, "save one line per sample");
  layout.header = read_csv_header(text, layout.dialect, layout.number_columns, file, content);
  layout.header.data_start += mark_bytes;
  return layout;
}

}  // namespace percuss::acquire
