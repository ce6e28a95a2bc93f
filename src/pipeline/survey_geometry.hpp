#pragma once
#include <set>
#include <vector>

#include "acquire/geometry/geometry.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// Fits a stated geometry to the measured points: one that numbers its points from 1 where the record counts from 0 is
/// renumbered, with its lines and faces. Says what was assumed.
std::vector<Warning> fit_geometry(acquire::Geometry& geometry, const std::set<int>& measured);

}  // namespace percuss::pipeline
