#pragma once
#include <cstddef>
#include <vector>

#include "core/io/csv_dialect.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {

/// The layout of a text of columns, found from its header and its last lines without reading the lines between.
struct CsvLayout {
  CsvDialect dialect;
  std::vector<std::size_t> number_columns;
  CsvHeader header;
};

/// errors  InputError: no text, no lines of numbers, too many columns. With CsvContent::time_record also: the columns
/// are those of an FRF or a spectrum.
CsvLayout layout_of_text(const FileBytes& bytes, CsvContent content);

}  // namespace percuss::acquire
