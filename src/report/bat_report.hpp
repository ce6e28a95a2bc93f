#pragma once
#include <optional>
#include <vector>

#include "model/bat/bat_collision.hpp"
#include "report/html/command_report.hpp"
#include "report/structure_report.hpp"

namespace percuss::report {

/// The impact and the times at which the bat's deflection is shown.
struct BatWaveRequest {
  double z_m = 0;              // of the impact
  std::vector<double> time_s;  // after first contact, ascending
};

/// JSON: percuss/model-bat/1. Modes, nodes and inertia of a bat, and the ball's exit speed from the flexible and from
/// the rigid bat. The positions of impact z_m count from the knob and ascend. All modes of `bat` take part. With `wave`
/// the table and a chart show the deflection along the bat, beside the exit speed for an impact at each position.
CommandReport bat_report(const model::BatModes& bat, const model::BeamStructure& structure,
                         const model::BatCollision& collision, const std::vector<double>& z_m,
                         const StructureOrigin& origin = {}, const std::optional<BatWaveRequest>& wave = {});

}  // namespace percuss::report
