#pragma once
#include <cstddef>
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/channels/channel_delays.hpp"

namespace percuss::pipeline {

/// The delays of acceleration channels that an analysis takes out before anything else.
struct DelayCorrection {
  bool automatic = false;       // those that the phases of the modes establish
  std::vector<double> delay_s;  // after the force: one for all channels or one per channel; empty: none
};

/// One delay per channel. errors  InputError: their number is neither one nor that of the channels, or one is longer
/// than a row.
std::vector<double> delay_per_channel(const std::vector<double>& delay_s, const acquire::Record& record);

/// The delays that are beyond doubt, one per channel; empty where there is none.
std::vector<double> established_delays_s(const std::vector<ChannelDelay>& delays, const acquire::Record& record);

/// The record with every acceleration channel moved forward by its delay, interpolated between samples. Exact up to
/// 0.44 of the sampling rate. Before and after a row a channel keeps the row's first and last value.
/// shape  delay_s [channels]
acquire::Record align_record(acquire::Record record, std::vector<double> delay_s);

/// Samples at the end of a row that such a record cannot fill.
std::size_t samples_without_data(const std::vector<double>& delay_s, double fs_Hz);

}  // namespace percuss::pipeline
