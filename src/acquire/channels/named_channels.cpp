#include "acquire/channels/named_channels.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/error.hpp"

namespace percuss::acquire {
namespace {

bool is_force_name(const std::string& name) { return name == "force" || name == "/force"; }

constexpr NamedSignal kForce{.is_force = true};

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

void require_setup_entry(const ChannelSetup& entry, std::size_t channels, const std::string& path) {
  const std::string where = path + ": channel set-up " + entry.name;
  const bool force = is_force_name(entry.name);
  if (!force && !channel_named(entry.name, channels)) {
    throw InputError("no such channel", where, "name force or an acceleration: " + names_of(channels));
  }
  const std::string own = force ? "force" : "acceleration";
  const bool fits = entry.role.empty() || entry.role == own || (!force && entry.role == "ignore");
  if (!fits) throw InputError("role " + entry.role + " for the " + own, where, "give the role " + own);
}

// The signal of a name; nothing where there is none.
std::optional<NamedSignal> signal_named(const std::string& name, std::size_t channels, bool has_force) {
  if (is_force_name(name)) return has_force ? std::optional(kForce) : std::nullopt;
  const auto channel = channel_named(name, channels);
  return channel ? std::optional(NamedSignal{.channel = *channel}) : std::nullopt;
}

class RoleFinder {
 public:
  RoleFinder(const ReadOptions& options, std::size_t channels, bool has_force, const std::string& path)
      : options_(options), channels_(channels), has_force_(has_force), path_(path) {
    for (const ChannelSetup& entry : options.setup) {
      if (signal_named(entry.name, channels, has_force) || is_force_name(entry.name)) continue;
      throw InputError("no such channel", path + ": channel set-up " + entry.name,
                       "name force or an acceleration: " + names_of(channels));
    }
  }

  NamedRoles find() const {
    NamedRoles roles{.force = force(), .accel = {}};
    if (options_.accel_channels.empty()) {
      for (const NamedSignal& signal : all_signals()) {
        if (signal != roles.force && is_response(signal)) roles.accel.push_back(signal);
      }
      if (roles.accel.empty())
        throw InputError("every acceleration is ignored", path_ + ": channel set-up", "keep one");
      return roles;
    }
    for (const std::string& name : options_.accel_channels) {
      const auto signal = signal_named(name, channels_, has_force_);
      if (!signal) throw InputError("no acceleration channel " + name, path_, names_of(channels_));
      if (signal == roles.force) {
        throw InputError(name + " is named as an acceleration and is the force", path_,
                         "name another signal as the force", {"force_channel"});
      }
      if (std::find(roles.accel.begin(), roles.accel.end(), *signal) != roles.accel.end())
        throw InputError("acceleration channel " + name + " requested twice", path_, "name it once");
      roles.accel.push_back(*signal);
    }
    return roles;
  }

 private:
  std::vector<NamedSignal> all_signals() const {
    std::vector<NamedSignal> all;
    if (has_force_) all.push_back(kForce);
    for (std::size_t channel = 0; channel < channels_; ++channel) all.push_back({.channel = channel});
    return all;
  }

  std::string role_of(const NamedSignal& signal) const {
    const ChannelSetup* const entry =
        signal.is_force ? force_setup(options_) : accel_setup(options_, signal.channel, channels_);
    return entry == nullptr ? "" : entry->role;
  }

  // Whether the signal is a response if the options choose no accelerations.
  bool is_response(const NamedSignal& signal) const {
    const std::string role = role_of(signal);
    return role == "acceleration" || (role.empty() && !signal.is_force);
  }

  std::optional<NamedSignal> force() const {
    if (!options_.force_channel.empty()) {
      const auto named = signal_named(options_.force_channel, channels_, has_force_);
      if (named) return named;
      throw InputError("no force channel " + options_.force_channel, path_,
                       "use the name force, or the name of an acceleration: " + names_of(channels_));
    }
    for (const NamedSignal& signal : all_signals()) {
      if (role_of(signal) == "force") return signal;
    }
    if (has_force_ && role_of(kForce).empty()) return kForce;
    if (options_.force_optional) return std::nullopt;
    throw InputError("the signal called force has the role " + role_of(kForce), path_ + ": channel set-up",
                     "give the role force to another channel");
  }

  const ReadOptions& options_;
  std::size_t channels_;
  bool has_force_;
  const std::string& path_;
};

}  // namespace

NamedRoles named_roles(const ReadOptions& options, std::size_t channels, bool has_force, const std::string& path) {
  return RoleFinder(options, channels, has_force, path).find();
}

std::vector<std::size_t> chosen_channels(const ReadOptions& options, std::size_t channels, const std::string& path) {
  for (const ChannelSetup& entry : options.setup) require_setup_entry(entry, channels, path);
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
