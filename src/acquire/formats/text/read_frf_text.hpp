#pragma once
#include <optional>

#include "acquire/channels/stored_frfs.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {

/// The FRFs of a text of columns (docs/reference/formats.md): frequency, then real and imaginary part, or magnitude and
/// phase, of each. Nothing when the columns are not named so: then it is a record of time. With `forced` three columns
/// or more without names are taken as frequency, real, imaginary, … errors  InputError with file, line and column:
/// columns that have no partner, uneven frequencies, gaps, numbers that are none.
std::optional<StoredFrfs> read_frf_text(const FileBytes& bytes, bool forced);

}  // namespace percuss::acquire
