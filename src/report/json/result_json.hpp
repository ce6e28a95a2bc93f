#pragma once
#include <string>

#include "pipeline/analysis.hpp"

namespace percuss {

// Members of the document percuss/analysis/1, each as JSON text of its own. What they are of has been computed.

/// `i` counts the hits.
std::string hit_json(const Record& record, std::size_t i, const AnalysedHit& hit);
/// `verdict`: nullptr where modes are not named.
std::string mode_json(const Mode& mode, std::size_t m, double window_decay_per_s, const ModeClassification* verdict);
std::string frf_json(const Analysis& analysis);
std::string coherence_json(const Analysis& analysis);
std::string modes_per_hit_json(const Analysis& analysis);
std::string stabilisation_json(const Stabilisation& diagram);

}  // namespace percuss
