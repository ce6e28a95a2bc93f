#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "acquire/hits/hits.hpp"
#include "acquire/record/record.hpp"
#include "pipeline/live/live_channels.hpp"
#include "pipeline/live/sample_history.hpp"

namespace percuss::pipeline {

/// The samples of one blow in SI units: force and responses, [1 + channels][samples].
using BlowSamples = std::vector<std::vector<double>>;

/// Frames first … first + samples − 1 of the history.
BlowSamples read_blow(const SampleHistory& history, const LiveChannels& channels, std::uint64_t first,
                      std::size_t samples);

/// `description` with one row of these samples.
acquire::Record record_of_blow(const acquire::Record& description, const BlowSamples& samples);

/// The samples that a blow needs until its decay has ended in every response: each has fallen into its noise or below
/// −52 dB of its start. Nothing where they ring at the end of these samples. `pretrigger` samples precede the pulse.
std::optional<std::size_t> decayed_samples(const acquire::Record& description, const BlowSamples& samples,
                                           std::size_t pretrigger);

/// The largest hit of a record of one row. errors  as acquire::find_hits
acquire::Hit largest_hit(const acquire::Record& record, std::size_t pretrigger);

}  // namespace percuss::pipeline
