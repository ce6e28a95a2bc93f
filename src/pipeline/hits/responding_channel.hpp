#pragma once
#include <cstddef>
#include <optional>

#include "acquire/hits/hits.hpp"
#include "acquire/record/record.hpp"

namespace percuss::pipeline {

/// The first response that moves within the samples of a hit: its level changes by a factor of ten or more. Nothing
/// where none moves, or where the hit has fewer than 64 samples.
std::optional<std::size_t> responding_channel(const acquire::Record& record, const acquire::Hit& hit);

}  // namespace percuss::pipeline
