#pragma once
#include <cstddef>
#include <vector>

#include "pipeline/channels/channel_clocks.hpp"
#include "pipeline/channels/channel_delays.hpp"
#include "pipeline/channels/channel_levels.hpp"

namespace percuss::pipeline {

/// Findings about the channels, from the modes that they measured.
struct ChannelFindings {
  std::vector<ChannelDelay> delays;            // that remain after any correction
  std::vector<ChannelDelay> corrected_delays;  // that were taken out: stated, or established by the phases
  std::vector<ChannelClock> clocks;
  std::vector<ChannelPair> pairs;
  double largest_velocity_mps = 0;  // that a mode has just after a hit; 0: the force is unknown
};

}  // namespace percuss::pipeline
