#pragma once
#include <cstddef>
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/channels/channel_delays.hpp"

namespace percuss::pipeline {

/// The delays of acceleration channels that an analysis takes out before anything else.
struct DelayCorrection {
  bool automatic = false;       // the delays that the phases of the modes establish
  std::vector<double> delay_s;  // after the force: one for all channels or one per channel; empty: none
};

/// The user's delays, one per channel or one for all; none for an empty list.
/// errors  InputError: another number of delays, or one that is longer than a row.
std::vector<ChannelDelay> stated_delays(const std::vector<double>& delay_s, const acquire::Record& record);

/// The record with every acceleration channel moved to earlier times by its delay, interpolated between samples. Exact
/// up to 0.44 of the sampling rate. Before and after a row a channel keeps the row's first and last value.
acquire::Record align_record(acquire::Record record, const std::vector<ChannelDelay>& delays);

/// The number of samples at the end of a row that align_record() computes wholly or partly from the repeated last
/// value. The length of the interpolation filter is included.
std::size_t samples_without_data(const std::vector<ChannelDelay>& delays, double fs_Hz);

}  // namespace percuss::pipeline
