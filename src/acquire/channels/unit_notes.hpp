#pragma once
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Adds to the notes of the record which units the file does not state: one note for the force, one for the
/// accelerations and one for the pressures, from `unit_assumed` of its signals.
void note_assumed_units(Record& record);

/// The note on a sound file whose scale neither the file nor the user states.
Message full_scale_note();

/// Whether the note says that nothing states the unit or the scale of the responses (note_codes.hpp).
bool is_about_assumed_units(const Message& note);

}  // namespace percuss::acquire
