#pragma once
#include <optional>
#include <vector>

#include "pipeline/analysis.hpp"

namespace percuss::report {

/// The coherence of one FRF over the spectral lines of the band.
struct CoherenceSummary {
  double mean = 0;
  double below = 0;  // the fraction of spectral lines below 0.9
};

/// Nothing for a single hit, which has no coherence.
std::optional<CoherenceSummary> summary_of_coherence(const pipeline::Analysis& analysis, const acquire::PointFrf& frf);

/// For each FRF of the analysis.
std::vector<std::optional<CoherenceSummary>> coherence_summaries(const pipeline::Analysis& analysis);

}  // namespace percuss::report
