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

/// `description` with one row that refers to these samples: they must outlive the record.
acquire::Record record_of_blow(const acquire::Record& description, const BlowSamples& samples);

/// The number of samples to keep per blow: until the decay has ended in every response (it has fallen into its noise or
/// below −52 dB of its start), and half as many to spare, but not more than given. Nothing if a response still rings at
/// the end. `pretrigger` samples precede the pulse.
std::optional<std::size_t> decayed_samples(const acquire::Record& description, const BlowSamples& samples,
                                           std::size_t pretrigger);

/// The largest hit of a record of one row.
/// errors  as acquire::find_hits
acquire::Hit largest_hit(const acquire::Record& record, std::size_t pretrigger);

}  // namespace percuss::pipeline
