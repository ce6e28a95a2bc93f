#pragma once
#include <string>
#include <string_view>

namespace percuss::acquire {

enum class DeviceKind { simulated, file, pipe, portaudio, alsa, plugin };

/// A device as users name it: "sim:…", "file:RECORD", "stdin:raw:…" or "stdin:wav", "portaudio:NAME", "alsa:NAME",
/// "plugin:PATH[:ARGUMENTS]". A name without such a beginning is one of PortAudio.
struct DeviceSpec {
  DeviceKind kind = DeviceKind::portaudio;
  std::string name;       // the text after the colon; of a plug-in, its path
  std::string arguments;  // of a plug-in
};

/// errors  InputError: empty; nothing after the colon where something is needed
DeviceSpec parse_device_spec(std::string_view text);

}  // namespace percuss::acquire
