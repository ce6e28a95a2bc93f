#include "acquire/channels/named_channels.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/error.hpp"

namespace percuss::acquire {
namespace {

bool is_force_name(const std::string& name) { return name == "force" || name == "/force"; }

// The channel, counted from 0, that a name or 1-based number stands for.
std::optional<std::size_t> channel_named(std::string name, std::size_t channels) {
  if (name.starts_with('/')) name.erase(0, 1);
  if (name.starts_with("accel")) {
    name.erase(0, 5);
    if (name.empty() && channels == 1) return 0;
    if (name.starts_with(' ')) name.erase(0, 1);
  }
  std::size_t number = 0;
  const char* const end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data(), end, number);
  if (error != std::errc() || stop != end || number < 1 || number > channels) return std::nullopt;
  return number - 1;
}

std::string names_of(std::size_t channels) {
  return channels == 1 ? "the only one is " + channel_name(0)
                       : "there are " + channel_name(0) + " to " + channel_name(channels - 1);
}

void check_setup(const ChannelSetup& entry, std::size_t channels, const std::string& path) {
  const std::string where = path + ": channel set-up " + entry.name;
  const bool force = is_force_name(entry.name);
  if (!force && !channel_named(entry.name, channels)) {
    throw InputError("no such channel", where, "name force or an acceleration: " + names_of(channels));
  }
  const std::string own = force ? "force" : "acceleration";
  const bool fits = entry.role.empty() || entry.role == own || (!force && entry.role == "ignore");
  if (!fits) throw InputError("role " + entry.role + " for the " + own, where, "give the role " + own);
}

}  // namespace

std::vector<std::size_t> chosen_channels(const ReadOptions& options, std::size_t channels, const std::string& path) {
  for (const ChannelSetup& entry : options.setup) check_setup(entry, channels, path);
  if (!options.force_channel.empty() && !is_force_name(options.force_channel)) {
    throw InputError("no force channel " + options.force_channel, path, "use the name force");
  }
  std::vector<std::size_t> chosen;
  for (const std::string& name : options.accel_channels) {
    const auto index = channel_named(name, channels);
    if (!index) throw InputError("no acceleration channel " + name, path, names_of(channels));
    if (std::find(chosen.begin(), chosen.end(), *index) != chosen.end()) {
      throw InputError("acceleration channel " + name + " requested twice", path, "name it once");
    }
    chosen.push_back(*index);
  }
  if (!chosen.empty()) return chosen;
  for (std::size_t index = 0; index < channels; ++index) {
    const ChannelSetup* const entry = accel_setup(options, index, channels);
    if (entry == nullptr || entry->role != "ignore") chosen.push_back(index);
  }
  if (chosen.empty()) throw InputError("every acceleration is ignored", path + ": channel set-up", "keep one");
  return chosen;
}

const ChannelSetup* force_setup(const ReadOptions& options) {
  for (const ChannelSetup& entry : options.setup) {
    if (is_force_name(entry.name)) return &entry;
  }
  return nullptr;
}

const ChannelSetup* accel_setup(const ReadOptions& options, std::size_t index, std::size_t channels) {
  for (const ChannelSetup& entry : options.setup) {
    if (channel_named(entry.name, channels) == index) return &entry;
  }
  return nullptr;
}

}  // namespace percuss::acquire
