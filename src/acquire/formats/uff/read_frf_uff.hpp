#pragma once
#include <optional>

#include "acquire/channels/stored_frfs.hpp"
#include "acquire/formats/uff/uff_contents.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {

/// The FRFs of a universal file: its functions 58 for which is_uff_frf holds (docs/reference/formats.md, "UFF"), with
/// the coherences (type 6) of the same degrees of freedom. The struck nodes are the points, and the responses are the
/// channels. A node that was struck in several directions holds several points (UffStruckPoints). With one struck node
/// and direction and many responses (roving sensors) the response nodes are the points. The signs of the FRFs are
/// changed to forces and motions in positive directions. Nothing when the file has no FRFs, or when it has time records
/// as well and `forced` is not set.
/// errors  InputError: functions differ in length or spacing, or an FRF of a channel is missing at a point.
std::optional<StoredFrfs> read_frf_uff(const FileBytes& file, const UffContents& contents, bool forced);

}  // namespace percuss::acquire
