#include "acquire/live/device_spec.hpp"

#include <array>

#include "core/error.hpp"

namespace percuss::acquire {
namespace {

struct KindPrefix {
  std::string_view prefix;
  DeviceKind kind;
};

constexpr std::array kKindPrefixes = {
    KindPrefix{"sim:", DeviceKind::simulated}, KindPrefix{"file:", DeviceKind::file},
    KindPrefix{"stdin:", DeviceKind::pipe},    KindPrefix{"portaudio:", DeviceKind::portaudio},
    KindPrefix{"alsa:", DeviceKind::alsa},     KindPrefix{"plugin:", DeviceKind::plugin},
};

}  // namespace

DeviceSpec parse_device_spec(std::string_view text) {
  DeviceSpec spec{.name = std::string(text)};
  for (const auto& [prefix, kind] : kKindPrefixes) {
    if (!text.starts_with(prefix)) continue;
    spec = {.kind = kind, .name = std::string(text.substr(prefix.size()))};
    break;
  }
  if (spec.kind == DeviceKind::pipe && spec.name.empty()) spec.name = "wav";  // the stream describes itself
  if (spec.name.empty())
    throw InputError("the device has no name", one_line(text), "percuss devices lists what can record", {"device"});
  if (spec.kind != DeviceKind::plugin) return spec;
  const std::size_t colon = spec.name.find(':');
  if (colon == std::string::npos) return spec;
  spec.arguments = spec.name.substr(colon + 1);
  spec.name.resize(colon);
  return spec;
}

}  // namespace percuss::acquire
