#include "acquire/live/list_devices.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "acquire/live/sound_cards/portaudio_library.hpp"
#include "acquire/live/sound_cards/sound_cards.hpp"

namespace percuss::acquire {
namespace {

bool names_card(const ListedDevice& listed, const SoundCardInput& input) {
  return listed.name.find(fmt::format("(hw:{},{})", input.card, input.device)) != std::string::npos;
}

}  // namespace

std::vector<ListedDevice> list_devices(const SoundFolders& folders) {
  std::vector<ListedDevice> listed;
  const PortAudioLibrary library;
  for (const PortAudioInput& input : library.inputs()) {
    ListedDevice device{.spec = "portaudio:" + input.name,
                        .name = input.name,
                        .host = input.host,
                        .channels = input.channels,
                        .default_fs_Hz = input.default_fs_Hz,
                        .rates_Hz = library.rates_Hz(input)};
    if (const auto card = card_in_name(input.name)) device.front_end = front_end_of_card(*card, folders.sysfs);
    listed.push_back(std::move(device));
  }
  for (const SoundCardInput& input : sound_card_inputs(folders.proc_asound, folders.dev_snd)) {
    const auto known =
        std::find_if(listed.begin(), listed.end(), [&](const auto& one) { return names_card(one, input); });
    const char* const problem = !input.permitted ? "no permission" : input.busy ? "busy" : "cannot be opened";
    if (known != listed.end()) {
      if (input.busy) known->problem = problem;
      continue;
    }
    listed.push_back({.spec = fmt::format("alsa:hw:{},{}", input.card, input.device),
                      .name = fmt::format("{} (hw:{},{})", input.name, input.card, input.device),
                      .host = "ALSA",
                      .front_end = front_end_of_card(input.card, folders.sysfs),
                      .problem = problem});
  }
  return listed;
}

std::string advice_without_devices(const std::vector<ListedDevice>& listed) {
  const auto has = [&](const char* problem) {
    return std::any_of(listed.begin(), listed.end(), [&](const auto& one) { return one.problem == problem; });
  };
  if (has("no permission")) return "no permission to record; add the user to the group audio, and log in again";
  if (has("busy")) return "the recording devices are busy or cannot be opened; end the program that records from them";
  return "no recording device was found; plug one in, or record from sim:, file: or stdin:";
}

}  // namespace percuss::acquire
