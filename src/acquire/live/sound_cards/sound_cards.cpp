#include "acquire/live/sound_cards/sound_cards.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "core/error.hpp"
#include "core/io/parse_number.hpp"

namespace percuss::acquire {
namespace {

// A line of /proc/asound/pcm is "01-00: USB Audio : USB Audio : playback 1 : capture 1".
bool parse_pcm_line(const std::string& line, SoundCardInput& input) {
  if (line.find("capture") == std::string::npos) return false;
  if (std::sscanf(line.c_str(), "%d-%d:", &input.card, &input.device) != 2) return false;  // NOLINT: two whole numbers
  const std::size_t begin = line.find(':') + 1;
  input.name = std::string(trimmed(std::string_view(line).substr(begin, line.find(':', begin) - begin)));
  return true;
}

bool is_busy(const std::string& folder) {
  std::ifstream status(folder + "/status");
  std::string first;
  return std::getline(status, first) && first != "closed";
}

}  // namespace

std::vector<SoundCardInput> sound_card_inputs(const std::string& proc_asound, const std::string& dev_snd) {
  std::vector<SoundCardInput> inputs;
  std::ifstream pcm(proc_asound + "/pcm");
  for (std::string line; std::getline(pcm, line);) {
    SoundCardInput input;
    if (!parse_pcm_line(line, input)) continue;
    const std::string node = fmt::format("{}/pcmC{}D{}c", dev_snd, input.card, input.device);
    input.permitted = ::access(node.c_str(), R_OK | W_OK) == 0;
    input.busy = is_busy(fmt::format("{}/card{}/pcm{}c/sub0", proc_asound, input.card, input.device));
    inputs.push_back(std::move(input));
  }
  std::sort(inputs.begin(), inputs.end(), [](const SoundCardInput& a, const SoundCardInput& b) {
    return std::pair(a.card, a.device) < std::pair(b.card, b.device);
  });
  return inputs;
}

void check_card_is_free(const std::vector<SoundCardInput>& cards, const std::string& name) {
  for (const SoundCardInput& known : cards) {
    const std::string address = fmt::format("hw:{},{}", known.card, known.device);
    if (name != address && name.find("(" + address + ")") == std::string::npos) continue;
    if (!known.permitted) {
      throw InputError("no permission to record", one_line(name), "add the user to the group audio, and log in again",
                       {"device"});
    }
    if (known.busy)
      throw InputError("the device is busy", one_line(name), "end the program that records from it", {"device"});
  }
}

}  // namespace percuss::acquire
