#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/survey.hpp"

namespace percuss::report {

/// A mode's displacements of the frame's points along x, y and z.
struct WireframeMode {
  std::string name;
  double freq_Hz = 0;
  std::vector<std::array<Complex, 3>> moves;  // [points]
};

/// The structure of a survey as points and lines, and its mode shapes.
struct Wireframe {
  std::vector<std::array<double, 3>> points;      // m
  std::vector<std::array<std::size_t, 2>> lines;  // pairs of indices into points
  std::vector<WireframeMode> modes;
};

/// Contains the points whose coordinates are known. The survey must have modes.
Wireframe wireframe(const pipeline::Survey& survey);

}  // namespace percuss::report
