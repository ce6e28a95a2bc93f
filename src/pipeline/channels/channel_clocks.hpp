#pragma once
#include <cstddef>
#include <vector>

#include "identify/model/frf_dataset.hpp"

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
/// FRFs are fitted alone; modes that both channels show are compared. Empty for one channel and for more than eight.
std::vector<ChannelClock> channel_clocks(const identify::FrfDataset& set, std::size_t channels);

}  // namespace percuss::pipeline
