#pragma once
#include <string>

#include "pipeline/analysis.hpp"

namespace percuss::report {

// Members of the document percuss/analysis/1, each as JSON text. The results that they need are computed already.

/// Hit number `i`.
std::string hit_json(const acquire::Record& record, std::size_t i, const pipeline::AnalysedHit& hit);
/// `classification`: nullptr for modes that are not classified.
std::string mode_json(const identify::Mode& mode, std::size_t m, double window_decay_per_s,
                      const identify::ModeClassification* classification);
std::string frf_json(const pipeline::Analysis& analysis);
std::string coherence_json(const pipeline::Analysis& analysis);
std::string modes_per_hit_json(const pipeline::Analysis& analysis);
std::string stabilisation_json(const identify::Stabilisation& diagram);

}  // namespace percuss::report
