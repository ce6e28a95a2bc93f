#pragma once
#include <cstdint>
#include <string>

namespace percuss::report {

/// The shape of a point's mark; shapes can be told apart without colour.
enum class ChartMark : std::uint8_t { circle, plus, open_diamond, diamond, triangle, square, cross };

/// The mark as an SVG element, centred at (x, y).
std::string chart_mark_svg(ChartMark mark, double x, double y, const char* colour);

/// Escapes a text for SVG: markup characters escaped, control characters as blanks.
std::string svg_escape(const std::string& text);

}  // namespace percuss::report
