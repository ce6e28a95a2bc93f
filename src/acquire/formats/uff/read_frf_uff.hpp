#pragma once
#include <optional>

#include "acquire/channels/stored_frfs.hpp"
#include "acquire/formats/uff/uff_contents.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {

/// The FRFs of a universal file: its functions 58 of type 4 (docs/reference/formats.md, "UFF"), with the coherences
/// (type 6) of the same places. The struck points are points, the responses channels; where one point was struck and
/// many responses were taken, these are the points (a roving sensor). Nothing when there are none, or records of time
/// beside them, unless `forced`.
/// errors  InputError: functions of other lengths or spacings, not one of every channel for every point.
std::optional<StoredFrfs> read_frf_uff(const FileBytes& file, const UffContents& contents, bool forced);

}  // namespace percuss::acquire
