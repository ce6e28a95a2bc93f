#pragma once
#include <string>
#include <vector>

namespace percuss::acquire {

/// An input that PortAudio found.
struct PortAudioInput {
  int index = 0;     // in PortAudio's list
  std::string name;  // "USB Audio: - (hw:1,0)"
  std::string host;  // "ALSA", "JACK Audio Connection Kit"
  std::size_t channels = 0;
  double default_fs_Hz = 0;
  double latency_s = 0;  // of large buffers
};

/// PortAudio while it is in use. It finds the devices when the first object is made.
class PortAudioLibrary {
 public:
  /// errors  InputError: PortAudio does not start, or would abort the program
  PortAudioLibrary();
  ~PortAudioLibrary();
  PortAudioLibrary(const PortAudioLibrary&) = delete;
  PortAudioLibrary& operator=(const PortAudioLibrary&) = delete;

  std::vector<PortAudioInput> inputs() const;
  /// Common rates that an input offers.
  std::vector<double> rates_Hz(const PortAudioInput& input) const;
};

/// The input with this name: its whole name, the part in parentheses, or a part that no other name has. `alsa_only`:
/// among ALSA's inputs.
/// errors  InputError: none, or several; the sound card is busy or forbidden
PortAudioInput find_input(const std::vector<PortAudioInput>& inputs, const std::string& name, bool alsa_only);

/// Discards what C libraries write to standard error while it lives: ALSA and JACK report each device that they look
/// for in vain. The leak checker of a sanitizer ignores the memory allocated meanwhile.
class SilencedErrors {
 public:
  SilencedErrors();
  ~SilencedErrors();
  SilencedErrors(const SilencedErrors&) = delete;
  SilencedErrors& operator=(const SilencedErrors&) = delete;

 private:
  int saved_;
};

}  // namespace percuss::acquire
