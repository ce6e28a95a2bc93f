#pragma once
#include <memory>
#include <string>

#include "acquire/live/device.hpp"

namespace percuss::synth {

/// The device "sim:": the session that `description` states (simulated_session.hpp), as a recorder of 32-bit floats in
/// N and m/s². It runs in real time, slower or faster by a factor, or as fast as the reader. Equal descriptions give
/// equal samples.
/// errors  InputError: as parse_simulated_session
std::unique_ptr<acquire::Device> open_simulated_device(const std::string& description,
                                                       const acquire::DeviceOptions& options = {});

}  // namespace percuss::synth
