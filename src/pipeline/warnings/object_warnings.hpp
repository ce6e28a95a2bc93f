#pragma once
#include <vector>

#include "identify/classify/classify.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// `assumed_tube` where bending and hoop rest on assumed angles, `not_a_tube` where the modes contradict them.
std::vector<Warning> object_warnings(const std::vector<identify::ModeClassification>& classifications,
                                     const identify::ClassifyOptions& options);

}  // namespace percuss::pipeline
