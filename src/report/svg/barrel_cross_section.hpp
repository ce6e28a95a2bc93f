#pragma once
#include <vector>

#include "pipeline/analysis.hpp"
#include "report/svg/shape_svg.hpp"

namespace percuss::report {

/// A sensor around the barrel, and how a mode moves it.
struct BarrelSensor {
  double angle_rad = 0;
  Complex residue;
};

/// The sensors with angles at the point where the mode is seen best.
std::vector<BarrelSensor> barrel_sensors(const pipeline::Analysis& analysis, const identify::Mode& mode);

/// The barrel's cross-section in each mode that two sensors saw and that has a family: bending shifts it, hoop turns it
/// into an ellipse.
std::vector<DeformedShape> barrel_cross_sections(const pipeline::Analysis& analysis,
                                                 const std::vector<identify::ModeClassification>& classifications);

}  // namespace percuss::report
