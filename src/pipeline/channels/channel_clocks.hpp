#pragma once
#include <cstddef>
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::pipeline {

/// Two channels must share at least this many modes.
inline constexpr std::size_t kMinClockModes = 4;

/// The frequencies of the modes in a channel, against their frequencies in the first channel.
struct ChannelClock {
  std::size_t channel = 0;
  double excess = 0, std = 0;  // relative difference from the first channel's frequencies, one value for all modes
  std::size_t modes = 0;       // that both channels show
  double log_chance = 0;       // natural logarithm of the probability of this agreement under one clock
  bool established() const;
};

/// One factor between the frequencies of all modes comes from the recorders' clocks: no structure and no sensor causes
/// it. Each channel's FRFs are fitted alone; modes that both channels show are compared. Empty for one channel and for
/// more than eight. Empty also where the modes of all channels leave no misfit and at most one pair of them overlaps:
/// one clock then explains them.
/// modes  of all channels, ascending
std::vector<ChannelClock> channel_clocks(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes,
                                         std::size_t channels);

}  // namespace percuss::pipeline
