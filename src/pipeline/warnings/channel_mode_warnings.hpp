#pragma once
#include <optional>
#include <vector>

#include "acquire/record/record.hpp"
#include "identify/classify/classify.hpp"
#include "pipeline/channels/channel_findings.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// mass_loading: frequencies that fall where a mode moves most.
std::vector<Warning> mass_loading_warnings(const std::vector<identify::Mode>& modes);

/// What is known of the directions of the accelerometers.
struct SensorDirections {
  bool angles_assumed = false;                 // the angles in the record are assumed, not stated
  std::optional<identify::SensorPair> tube{};  // two sensors of a tube, which tube_warnings() judges instead
};

/// skew, clock_mismatch, units_differ, implausible_motion, reversed, same_motion, dead_channel, unexcited_channel.
/// `correctable`: the input is a record in time, from which a delay can be taken out. `responding`: [channels] which
/// channels clearly respond to the hits (responding_channels()); empty where this is not known.
std::vector<Warning> channel_mode_warnings(const acquire::Record& record, const std::vector<identify::Mode>& modes,
                                           const ChannelFindings& findings, bool correctable,
                                           const SensorDirections& sensors = {},
                                           const std::vector<bool>& responding = {});

}  // namespace percuss::pipeline
