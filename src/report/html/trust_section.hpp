#pragma once
#include <string>
#include <vector>

#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::report {

/// The section "How far can this test be trusted?" of a page: all findings and warnings, most serious first, each once
/// with its severity and its remedy.
std::string trust_section(const std::vector<pipeline::Warning>& warnings,
                          const std::vector<pipeline::AnalysedHit>& hits);

}  // namespace percuss::report
