#include "acquire/live/open_device.hpp"

#include <stdexcept>

#include "acquire/live/file_device.hpp"
#include "acquire/live/pipe_device.hpp"
#include "acquire/live/plugin_device.hpp"
#include "acquire/live/portaudio_device.hpp"

namespace percuss::acquire {

std::unique_ptr<Device> open_device(const std::string& text, const DeviceOptions& options,
                                    const DeviceOpener& simulated) {
  const DeviceSpec spec = parse_device_spec(text);
  switch (spec.kind) {
    case DeviceKind::simulated:
      return simulated(spec.name, options);
    case DeviceKind::file:
      return open_file_device(spec.name, options);
    case DeviceKind::pipe:
      return open_pipe_device(spec.name, 0, options);
    case DeviceKind::plugin:
      return open_plugin_device(spec.name, spec.arguments, options);
    case DeviceKind::portaudio:
      return open_portaudio_device(spec.name, false, options);
    case DeviceKind::alsa:
      return open_portaudio_device(spec.name, true, options);
  }
  throw std::logic_error("a kind of device is missing");
}

}  // namespace percuss::acquire
