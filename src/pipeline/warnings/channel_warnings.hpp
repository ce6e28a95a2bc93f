#pragma once
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// input: each note of the reader, as a warning.
std::vector<Warning> input_warnings(const acquire::Record& record);

/// dead_channel, coarse_steps, channel by channel.
std::vector<Warning> channel_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits);

}  // namespace percuss::pipeline
