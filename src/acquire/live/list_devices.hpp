#pragma once
#include <optional>
#include <string>
#include <vector>

#include "acquire/live/sound_cards/usb_front_end.hpp"

namespace percuss::acquire {

/// A device that can record, or one that cannot at present.
struct ListedDevice {
  std::string spec;  // to open it: "portaudio:USB Audio: - (hw:1,0)"
  std::string name;
  std::string host;                // of PortAudio: "ALSA"
  std::size_t channels = 0;        // 0: not known
  double default_fs_Hz = 0;        // 0: not known
  std::vector<double> rates_Hz{};  // common rates that it offers
  std::optional<UsbFrontEnd> front_end{};
  std::string problem{};  // why it cannot record: "busy", "no permission", "cannot be opened"; empty: it can
};

/// The folders that describe the sound cards; copies for tests.
struct SoundFolders {
  std::string sysfs = "/sys", proc_asound = "/proc/asound", dev_snd = "/dev/snd";
};

/// Sound cards and USB front ends. Cards that PortAudio cannot open are listed with the reason.
std::vector<ListedDevice> list_devices(const SoundFolders& folders = {});

/// What to do when there is nothing to record with: one sentence.
std::string advice_without_devices(const std::vector<ListedDevice>& listed);

}  // namespace percuss::acquire
