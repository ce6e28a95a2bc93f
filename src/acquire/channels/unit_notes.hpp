#pragma once
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Adds to the notes of the record which units the file does not state: one note for the force, one for the
/// accelerations and one for the pressures, from `unit_assumed` of its signals.
void note_assumed_units(Record& record);

}  // namespace percuss::acquire
