#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/hits/analysed_hit.hpp"

namespace percuss::pipeline {

/// Samples before a pulse in which a recorder's filter of linear phase rings.
inline constexpr std::size_t kFilterBeforePulse = 72;

/// The last blow before a hit in the hit's row, and the sample of the row from which no earlier force acts.
struct LastBlow {
  std::optional<std::size_t> hit;  // none: the hit is the first in its row
  std::size_t end = 0;
};
LastBlow last_blow_before(const std::vector<AnalysedHit>& hits, std::size_t hit);

/// Whether a graded response of this hit may ring before it (ResponseGrade::may_ring_before).
bool may_ring_before(const AnalysedHit& hit);

/// [hits] whether the structure moves before the impact, so that an integral of its acceleration from there begins with
/// a wrong velocity. It moves where ResponseGrade::may_ring_before says so, or where a long rest after the last blow in
/// the row holds more than white noise.
/// hits  indices into `impacts`
std::vector<bool> moves_before(const acquire::Record& record, const std::vector<AnalysedHit>& impacts,
                               const std::vector<std::size_t>& hits, std::size_t threads);

}  // namespace percuss::pipeline
