#pragma once
#include <memory>
#include <string>

#include "acquire/live/device.hpp"

namespace percuss::acquire {

/// Samples that another program writes to a pipe: "wav", or "raw:ENCODING:RATE:CHANNELS" such as "raw:s24:51200:2".
/// Integers are divided by their full scale; floating-point numbers are as stored. The writer waits while the ring is
/// full, so nothing is lost here. A WAV stream that percuss wrote states names and scales: its samples are in SI units,
/// unless the set-up states units or sensitivities. The stream is finished where the data end, or where a WAV header
/// says so.
/// errors  InputError: another description; not a WAV header, compressed, damaged calibration, or no header within
/// 10 s; as require_rate
std::unique_ptr<Device> open_pipe_device(const std::string& description, int descriptor = 0,
                                         const DeviceOptions& options = {});

}  // namespace percuss::acquire
