#pragma once
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"

namespace percuss {

/// What page/page.js draws of an analysis, as JSON in ASCII: {"frf": {first_hz, df_hz, curves: [{name, db, phase_deg,
/// coherence, sigma_db, fit_db}]}, "modes": [{hz, name, family, re, im}], "hits": [{name, accepted, ms, force_n,
/// decay_s, decay_db}], "stabilisation"}. Numbers as picture_numbers. FRFs of the strongest outputs, at most eight.
std::string analysis_pictures(const Analysis& analysis, const std::vector<Verdict>& verdicts, bool stabilisation);

}  // namespace percuss
