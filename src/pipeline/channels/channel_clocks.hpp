#pragma once
#include <cstddef>
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::pipeline {

/// The frequencies that a channel shows, against those of the first channel.
struct ChannelClock {
  std::size_t channel = 0;
  double excess = 0, std = 0;  // of every frequency, relative
  std::size_t modes = 0;       // seen by both
  double log_chance = 0;       // natural logarithm of the probability of this agreement under one clock
  bool established() const;
};

/// One factor between the frequencies of all modes is a clock: no structure and no sensor does that. Each channel's
/// FRFs are fitted alone; modes that both channels show are compared. Empty for one channel, for more than eight, and
/// where the modes of all channels together leave no misfit and at most two overlap: one clock then explains them.
/// modes  of all channels, ascending
std::vector<ChannelClock> channel_clocks(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes,
                                         std::size_t channels);

}  // namespace percuss::pipeline
