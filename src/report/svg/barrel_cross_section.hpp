#pragma once
#include <vector>

#include "pipeline/analysis.hpp"
#include "report/svg/shape_svg.hpp"

namespace percuss::report {

/// A sensor around the barrel, and its motion in a mode.
struct BarrelSensor {
  double angle_rad = 0;
  Complex residue;
};

/// The sensors with angles, at the point where the mode has its largest residue.
std::vector<BarrelSensor> barrel_sensors(const pipeline::Analysis& analysis, const identify::Mode& mode);

/// The barrel's cross-section in each classified mode that two sensors measured: bending shifts it, a hoop mode turns
/// it into an ellipse.
std::vector<DeformedShape> barrel_cross_sections(const pipeline::Analysis& analysis,
                                                 const std::vector<identify::Mode>& modes,
                                                 const std::vector<identify::ModeClassification>& classifications);

}  // namespace percuss::report
