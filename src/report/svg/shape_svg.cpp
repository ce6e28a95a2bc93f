#include "report/svg/shape_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "report/svg/chart_mark.hpp"

namespace percuss::report {
namespace {

constexpr double kCell = 240, kMargin = 12, kTitle = 32, kName = 24;
constexpr std::size_t kBeside = 3;

struct Box {
  std::array<double, 2> low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  std::array<double, 2> high{-low[0], -low[1]};

  void cover(const std::vector<Polyline>& lines) {
    for (const Polyline& line : lines) {
      for (const auto& point : line) {
        for (std::size_t i = 0; i < 2; ++i) {
          low.at(i) = std::min(low.at(i), point.at(i));
          high.at(i) = std::max(high.at(i), point.at(i));
        }
      }
    }
  }
  double scale() const {
    const double size = std::max(high[0] - low[0], high[1] - low[1]);
    return size > 0 ? (kCell - 2 * kMargin) / size : 1;
  }
};

void draw(const std::vector<Polyline>& lines, const Box& box, double left, double top, const char* ink,
          std::string& out) {
  const double scale = box.scale();
  std::string path;
  for (const Polyline& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", i == 0 ? "M" : "L",
                     left + kCell / 2 + scale * (line[i][0] - (box.low[0] + box.high[0]) / 2),
                     top + kCell / 2 - scale * (line[i][1] - (box.low[1] + box.high[1]) / 2));
    }
  }
  fmt::format_to(std::back_inserter(out),
                 R"(<path d="{}" fill="none" {}/>)"
                 "\n",
                 path, ink);
}

}  // namespace

SvgFragment shape_svg(const std::string& title, const std::vector<DeformedShape>& drawings) {
  Box box;
  for (const DeformedShape& drawing : drawings) {
    box.cover(drawing.rest);
    box.cover(drawing.moved);
  }
  const std::size_t beside = std::clamp<std::size_t>(drawings.size(), 1, kBeside);
  const std::size_t rows = (drawings.size() + beside - 1) / beside;
  SvgFragment piece{.body = fmt::format("<title>{0}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
                                        "<text x=\"{1}\" y=\"20\" font-size=\"15\">{0}</text>\n",
                                        svg_escape(title), kMargin),
                    .width = kCell * static_cast<double>(beside),
                    .height = kTitle + (kCell + kName) * static_cast<double>(rows)};
  for (std::size_t i = 0; i < drawings.size(); ++i) {
    const std::size_t row = i / beside, column = i % beside;
    const double left = kCell * static_cast<double>(column);
    const double top = kTitle + (kCell + kName) * static_cast<double>(row);
    draw(drawings[i].rest, box, left, top, R"(stroke="#999" stroke-dasharray="3 3")", piece.body);
    draw(drawings[i].moved, box, left, top, R"(stroke="#0072B2" stroke-width="2")", piece.body);
    fmt::format_to(std::back_inserter(piece.body),
                   R"(<text x="{:.1f}" y="{:.1f}" text-anchor="middle">{}</text>)"
                   "\n",
                   left + kCell / 2, top + kCell + 12, svg_escape(drawings[i].name));
  }
  return piece;
}

}  // namespace percuss::report
