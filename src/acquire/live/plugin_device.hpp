#pragma once
#include <memory>
#include <string>

#include "acquire/live/device.hpp"

namespace percuss::acquire {

/// Opens a device of a plug-in (include/percuss/device_plugin.h), a shared library at `path`.
/// errors  InputError: not a library, not a plug-in, or a plug-in of another version; the plug-in states an impossible
/// layout, or cannot open the device (with its own message).
std::unique_ptr<Device> open_plugin_device(const std::string& path, const std::string& arguments,
                                           const DeviceOptions& options = {});

}  // namespace percuss::acquire
