#pragma once
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Adds notes on the units that the file does not state (`unit_assumed` of a signal): one note for the force, one for
/// the accelerations and one for the pressures.
void note_assumed_units(Record& record);

/// The note on a sound file whose scale neither the file nor the user states.
Message full_scale_note();

/// Whether the note says that the unit or the scale of the responses is not stated (note_codes.hpp).
bool is_about_assumed_units(const Message& note);

}  // namespace percuss::acquire
