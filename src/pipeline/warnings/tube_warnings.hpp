#pragma once
#include <vector>

#include "acquire/record/record.hpp"
#include "identify/classify/classify.hpp"
#include "identify/model/mode.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// What the ratios of the residues at two sensors of a tube say against the test:
///   midway_hit          all ratios are about −1, so that bending and hoop look alike, or about +1, so that hoop modes
///                       have nodes at both sensors
///   reversed            the ratios of all modes are far likelier if one sensor is reversed (log_fault_evidence)
///   units_differ        they are far likelier with a factor of two units: 9.81, 10, 39.4, 386, 1000 or an
///                       inverse; or they show another factor that no right set-up has (sensor_factor)
///   angles_contradicted the ratios do not fit the stated angles
///   order_missing       the two lowest bending modes are closer than the first two of a tube
/// `complete`: the modes are all modes of the band.
std::vector<Warning> tube_warnings(const acquire::Record& record, const std::vector<identify::Mode>& modes,
                                   const std::vector<identify::ModeClassification>& classifications,
                                   const identify::ClassifyOptions& options, bool complete);

}  // namespace percuss::pipeline
