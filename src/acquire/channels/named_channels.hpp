#pragma once
#include <cstddef>
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

/// The set-up's entry for the force, or for acceleration channel `index` of `channels`; nullptr without one.
const ChannelSetup* force_setup(const ReadOptions& options);
const ChannelSetup* accel_setup(const ReadOptions& options, std::size_t index, std::size_t channels);

}  // namespace percuss::acquire
