#pragma once
#include <optional>

#include "acquire/channels/stored_frfs.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {

/// The FRFs of a text of columns (docs/reference/formats.md): frequency, then real and imaginary part, or magnitude and
/// phase, of each FRF. Nothing when the column names are different: then the text is a time record. With `forced`, the
/// name of the first column does not matter, and three or more columns with other names or none are frequency, real,
/// imaginary, …
/// errors  InputError with file, line and column: a column without its partner, uneven frequencies, empty cells, texts
/// that are not numbers.
std::optional<StoredFrfs> read_frf_text(const FileBytes& bytes, bool forced);

}  // namespace percuss::acquire
