#pragma once
#include <string>
#include <vector>

#include "identify/shapes/scan_outliers.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// missing_position: `missing` lists the positions in inches, "5 in, 5.5 in".
Warning missing_positions(const std::string& missing);
/// few_points: fewer than three `positions` have usable hits.
Warning few_positions(std::size_t positions);
/// one_hit_each: the ± lacks the errors of the hits' places.
Warning one_hit_per_position();
/// misplaced_hits: `outliers` must not be empty. `position_m`: the positions of the points of the shapes.
Warning misplaced_hits(const std::vector<identify::ScanOutlier>& outliers, const std::vector<double>& position_m);

}  // namespace percuss::pipeline
