#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "acquire/record/channel_name.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

// Channels of files that give them no names: "force" and "accel 1", "accel 2", …

/// The acceleration channels to read, counted from 0, in the order of the options; without a choice all channels that
/// the set-up does not ignore.
/// errors  InputError: an option or the set-up names a channel that does not exist, or gives a role that the layout
/// does not allow.
std::vector<std::size_t> chosen_channels(const ReadOptions& options, std::size_t channels, const std::string& path);

/// A signal of a file whose signals are called "force" and "accel 1", "accel 2", …
struct NamedSignal {
  bool is_force = false;    // the signal called "force"; else acceleration channel `channel`
  std::size_t channel = 0;  // counted from 0
  bool operator==(const NamedSignal&) const = default;
};

/// Which signals are the force and the accelerations.
struct NamedRoles {
  std::optional<NamedSignal> force;  // nothing: no force
  std::vector<NamedSignal> accel;    // in the order of the options; without them "force" first, then the channels
};

/// The roles by the options, else by the set-up's roles, else by the names. The signal called "accel 1" may be the
/// force, and the signal called "force" an acceleration. `has_force`: the file has a signal called "force".
/// errors  InputError: an option or the set-up names a signal that does not exist; one signal with two roles; no
/// acceleration; no force, unless it is optional.
NamedRoles named_roles(const ReadOptions& options, std::size_t channels, bool has_force, const std::string& path);

/// The set-up's entry for the force, or for acceleration channel `index` of `channels`; nullptr without one.
const ChannelSetup* force_setup(const ReadOptions& options);
const ChannelSetup* accel_setup(const ReadOptions& options, std::size_t index, std::size_t channels);

}  // namespace percuss::acquire
