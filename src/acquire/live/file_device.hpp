#pragma once
#include <memory>

#include "acquire/live/device.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Replays a record for tests: its force, if it has one, then its accelerations, in SI units. Frames come in real time,
/// or as fast as they are read. Rows follow one another after a pause of one second, because the time between them is
/// unknown.
/// errors  InputError: the record has no samples
std::unique_ptr<Device> replay_device(Record record, const DeviceOptions& options = {});

/// Replays a file of any format. The rate of the options applies only if the file states none. The set-up of the
/// options applies to the reading of the file, and DeviceFormat::setup then holds it, if the file does not identify its
/// force, or if the set-up names further signals or states units or sensitivities of named signals.
/// errors  InputError: as open_record, require_rate; neither file nor set-up identifies the force and the responses
std::unique_ptr<Device> open_file_device(const std::string& path, const DeviceOptions& options = {});

}  // namespace percuss::acquire
