#pragma once
#include <string>
#include <vector>

namespace percuss::report {

/// A drawing and its size in pixels.
struct SvgFragment {
  std::string body;  // elements of SVG 1.1
  double width = 0, height = 0;
  const char* ink = "black";  // default colour
};

/// Drawings, stacked, as one document.
std::string svg_document(const std::vector<SvgFragment>& pieces);

}  // namespace percuss::report
