#pragma once
#include <cstddef>
#include <vector>

#include "acquire/channels/signal_table.hpp"
#include "acquire/formats/uff/uff_contents.hpp"
#include "acquire/formats/uff/uff_rows.hpp"
#include "core/error.hpp"

namespace percuss::acquire {

/// Adds the rows of a file to the table of its signals: each row's point, the driving points, and the places and
/// directions of the struck points or of the roving sensors. Sets SignalTable::sensor_roves.
/// rows  at least one, each with at least one function
/// errors  InputError: a point number out of range; a sensor that is at several nodes while one place was struck.
void add_uff_rows(const std::vector<UffRow>& rows, const UffContents& contents, const FileBytes& file,
                  SignalTable& table);

/// The sign, 1 or -1, of the response row[signal] for a force and a motion in positive directions.
double uff_sign_in_row(const UffRow& row, const SignalRoles& roles, std::size_t signal);

/// Adds a note if the directions change the sign of responses.
void note_uff_signs(const std::vector<UffRow>& rows, const SignalRoles& roles, std::vector<Message>& notes);

}  // namespace percuss::acquire
