#pragma once
#include <vector>

#include "acquire/record/record.hpp"
#include "identify/model/mode.hpp"
#include "pipeline/warnings/point_names.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// sensors_disagree, for each pair of fixed sensors of a roving-hammer survey: the points at which they contradict the
/// other points, see reference_contradictions().
std::vector<Warning> reference_warnings(const std::vector<acquire::SignalInfo>& accel,
                                        const std::vector<identify::Mode>& modes, const PointNames& names);

}  // namespace percuss::pipeline
