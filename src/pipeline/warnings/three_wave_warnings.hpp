#pragma once
#include <vector>

#include "identify/classify/classify.hpp"
#include "identify/model/mode.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// `three_waves` where modes may have three waves around the barrel, which two sensors do not tell from bending.
std::vector<Warning> three_wave_warnings(const std::vector<identify::Mode>& modes,
                                         const std::vector<identify::ModeClassification>& classifications);

}  // namespace percuss::pipeline
