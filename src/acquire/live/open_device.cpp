#include "acquire/live/open_device.hpp"

#include "acquire/live/file_device.hpp"
#include "core/error.hpp"

namespace percuss::acquire {

std::unique_ptr<Device> open_device(const std::string& text, const DeviceOptions& options,
                                    const DeviceOpener& simulated) {
  const DeviceSpec spec = parse_device_spec(text);
  switch (spec.kind) {
    case DeviceKind::simulated:
      return simulated(spec.name, options);
    case DeviceKind::file:
      return open_file_device(spec.name, options);
    default:
      break;
  }
  throw InputError("this kind of device is not supported", text, "choose another device", {"device"});
}

}  // namespace percuss::acquire
