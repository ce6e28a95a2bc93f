#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/survey.hpp"
#include "report/svg/plot_geometry.hpp"

namespace percuss::report {

/// A mode's displacements of the frame's points along x, y and z, as a motion Re(φ e^{jωt}). The largest displacement
/// of a point is 1. The phase makes the sum of the squared displacements largest at ωt = 0. The sign is such that the
/// point with the largest component along its normal then moves in the direction of this normal.
struct WireframeMode {
  std::string name;
  double freq_Hz = 0, damping_ratio = 0, mpc = 0;
  std::vector<std::array<Complex, 3>> moves;  // [points]
};

/// A sensor at a point, and the direction of its positive values.
struct WireframeSensor {
  std::size_t at = 0;  // index of the point
  std::array<double, 3> direction{};
};

/// The structure of a survey as points, lines and faces, and its mode shapes.
struct Wireframe {
  PlotMesh mesh;
  std::vector<WireframeSensor> sensors;
  std::vector<WireframeMode> modes;
};

/// Contains the points whose coordinates are known. Fixed sensors are drawn at the driving points,
/// a roving sensor at every point where it was. The survey must have modes.
Wireframe wireframe(const pipeline::Survey& survey);

}  // namespace percuss::report
