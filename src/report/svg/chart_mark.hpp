#pragma once
#include <cstdint>
#include <string>

namespace percuss::report {

/// How a point is drawn: shapes that stay apart without colour.
enum class ChartMark : std::uint8_t { circle, plus, open_diamond, diamond, triangle, square, cross };

/// The mark as an element of SVG, its middle at (x, y).
std::string chart_mark_svg(ChartMark mark, double x, double y, const char* colour);

/// A text as it may stand in SVG: what would be read as markup escaped, control characters as blanks.
std::string svg_escape(const std::string& text);

}  // namespace percuss::report
