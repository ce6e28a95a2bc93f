#include "report/svg/svg_fragment.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace percuss::report {
namespace {

std::string piece_text(const SvgFragment& piece, double top) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" y=\"{0}\" viewBox=\"0 0 {1} {2}\" width=\"{1}\" height=\"{2}\" "
      "font-family=\"system-ui, sans-serif\" font-size=\"12\" fill=\"{3}\" role=\"img\">\n{4}</svg>\n",
      top, piece.width, piece.height, piece.ink, piece.body);
}

}  // namespace

std::string svg_document(const std::vector<SvgFragment>& pieces) {
  if (pieces.size() == 1) return piece_text(pieces.front(), 0);
  std::string inner;
  double width = 0, top = 0;
  for (const SvgFragment& piece : pieces) {
    inner += piece_text(piece, top);
    width = std::max(width, piece.width);
    top += piece.height;
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n{2}</svg>\n",
      width, top, inner);
}

}  // namespace percuss::report
