#pragma once
#include <string>
#include <vector>

namespace percuss::acquire {

/// An input of a sound card, as Linux describes it.
struct SoundCardInput {
  int card = 0, device = 0;
  std::string name;
  bool permitted = true;  // this user may open it
  bool busy = false;      // a program records from it
};

/// The inputs of all sound cards. Folders: "/proc/asound" and "/dev/snd", or copies for tests.
std::vector<SoundCardInput> sound_card_inputs(const std::string& proc_asound = "/proc/asound",
                                              const std::string& dev_snd = "/dev/snd");

/// Throws if the card cannot be opened. `name` is "hw:1,0", or ends in it in brackets: "485B39: USB Audio (hw:1,0)".
/// errors  InputError: no permission; busy
void check_card_is_free(const std::vector<SoundCardInput>& cards, const std::string& name);

}  // namespace percuss::acquire
