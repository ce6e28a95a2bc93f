#pragma once
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"

namespace percuss {

/// What was found, in a sentence or two: "5 modes between 60 and 3200 Hz: bending at 169.0, 402.1 and 1204 Hz, hoop at
/// 1900 Hz."
std::string summary_sentence(const Analysis& analysis, const std::vector<ModeClassification>& classifications);

}  // namespace percuss
