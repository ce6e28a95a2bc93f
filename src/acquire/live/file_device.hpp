#pragma once
#include <memory>

#include "acquire/live/device.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Replays a record: its force, where it has one, then its accelerations, in SI units. In real time, or as fast as the
/// reader. Rows follow one another after a pause of one second, as nothing says how much time passed between them. For
/// tests.
/// errors  InputError: the record has no samples
std::unique_ptr<Device> replay_device(Record record, const DeviceOptions& options = {});

/// As above, for a file of any format. A rate in the options is for a file that states none. The set-up of the options
/// serves to read the file (DeviceFormat::setup) where the file does not tell its force, or where the set-up names
/// further signals, or states units or sensitivities of named signals.
/// errors  InputError: as open_record, require_rate; nothing tells which signals are the force and the responses
std::unique_ptr<Device> open_file_device(const std::string& path, const DeviceOptions& options = {});

}  // namespace percuss::acquire
