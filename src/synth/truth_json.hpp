#pragma once
#include <string>

#include "synth/synthesise.hpp"

namespace percuss::synth {

/// The truth as a document "percuss/synth-truth/1" (docs/guides/synth.md), for comparison with an analysis.
std::string truth_json(const Truth& truth);

}  // namespace percuss::synth
