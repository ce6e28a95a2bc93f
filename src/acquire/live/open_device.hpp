#pragma once
#include <functional>
#include <memory>
#include <string>

#include "acquire/live/device.hpp"
#include "acquire/live/device_spec.hpp"

namespace percuss::acquire {

using DeviceOpener = std::function<std::unique_ptr<Device>(const std::string& name, const DeviceOptions&)>;

/// Opens a device that does not run yet. `simulated` opens "sim:" (synth/simulated_device.hpp), which a higher layer
/// makes.
/// errors  InputError: as parse_device_spec; the device is missing, busy or forbidden
std::unique_ptr<Device> open_device(const std::string& text, const DeviceOptions& options,
                                    const DeviceOpener& simulated);

}  // namespace percuss::acquire
