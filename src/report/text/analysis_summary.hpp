#pragma once
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"

namespace percuss::report {

/// The modes in a sentence: "4 modes between 60 and 3200 Hz: bending at 169.0, 402.1 and 1204 Hz; hoop at 1900 Hz."
/// modes  in place of the analysis's own
std::string summary_sentence(const pipeline::Analysis& analysis,
                             const std::vector<identify::ModeClassification>& classifications,
                             const std::vector<identify::Mode>* modes = nullptr);

}  // namespace percuss::report
