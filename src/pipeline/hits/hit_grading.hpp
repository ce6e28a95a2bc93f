#pragma once
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/hits/hit_spectra.hpp"

namespace percuss::pipeline {

/// The user's demands on the hits.
struct HitDemands {
  std::vector<std::size_t> accept, reject;  // indices of hits, or kEveryHit
  std::optional<double> high_Hz;            // upper end of the band, which the bandwidth of the force should reach
};

/// Stands for all hits in a list of hit indices.
inline constexpr std::size_t kEveryHit = std::numeric_limits<std::size_t>::max();

/// Whether `list` names hit i: by its index, or by kEveryHit where `other` does not hold this index.
bool names_hit(const std::vector<std::size_t>& list, const std::vector<std::size_t>& other, std::size_t i);

/// errors  InputError with the option `option`: an index that is neither below `hits`, the number of hits, nor
/// kEveryHit.
void require_hits(const std::vector<std::size_t>& indices, std::size_t hits, const acquire::Record& record,
                  const char* option);

/// Accepts hits by their force and by the user's demands.
/// errors  InputError: an index of a hit that does not exist.
std::vector<AnalysedHit> grade_by_force(std::vector<acquire::Hit> found, const acquire::Record& record,
                                        const HitDemands& demands);

/// Adds the responses' grades and findings; rejects hits whose findings demand it, unless the user accepted them.
void grade_by_responses(std::vector<AnalysedHit>& hits, const HitResponses& responses);

}  // namespace percuss::pipeline
