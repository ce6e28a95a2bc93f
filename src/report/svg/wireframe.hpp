#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/survey.hpp"

namespace percuss::report {

/// A mode's movement of the points of a frame, along x, y and z.
struct WireframeMode {
  std::string name;
  double freq_Hz = 0;
  std::vector<std::array<Complex, 3>> moves;  // [points]
};

/// The structure of a survey as points and lines, and how its modes move it.
struct Wireframe {
  std::vector<std::array<double, 3>> points;      // m
  std::vector<std::array<std::size_t, 2>> lines;  // of point to point, by place
  std::vector<WireframeMode> modes;
};

/// Of the points that can be drawn; the survey has modes.
Wireframe wireframe(const pipeline::Survey& survey);

}  // namespace percuss::report
