#include "report/svg/shape_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "report/svg/chart_mark.hpp"

namespace percuss::report {
namespace {

constexpr double kCell = 240, kMargin = 12, kTitle = 32, kName = 24;
constexpr std::size_t kPerRow = 3;
constexpr int kColourSteps = 4;  // on each side of grey

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
  // The SVG coordinates of a point in the cell whose upper left corner is (left, top).
  std::array<double, 2> place(const std::array<double, 2>& point, double left, double top) const {
    return {left + kCell / 2 + scale() * (point[0] - (low[0] + high[0]) / 2),
            top + kCell / 2 - scale() * (point[1] - (low[1] + high[1]) / 2)};
  }
  double scale() const {
    const double size = std::max(high[0] - low[0], high[1] - low[1]);
    return size > 0 ? (kCell - 2 * kMargin) / size : 1;
  }
};

void draw(const std::vector<Polyline>& lines, const Box& box, double left, double top, const char* ink,
          std::string& out) {
  if (lines.empty()) return;
  std::string path;
  for (const Polyline& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const auto [x, y] = box.place(line[i], left, top);
      fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", i == 0 ? "M" : "L", x, y);
    }
  }
  fmt::format_to(std::back_inserter(out),
                 R"(<path d="{}" fill="none" {}/>)"
                 "\n",
                 path, ink);
}

std::string colour_of(int step) {
  constexpr std::array<double, 3> kRest{154, 164, 174}, kPlus{0, 114, 178}, kMinus{213, 94, 0};
  const double part = std::abs(step) / static_cast<double>(kColourSteps);
  const auto& strong = step < 0 ? kMinus : kPlus;
  std::array<long, 3> mixed{};
  for (std::size_t i = 0; i < 3; ++i) mixed.at(i) = std::lround(kRest.at(i) + part * (strong.at(i) - kRest.at(i)));
  return fmt::format("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2]);
}

// The moved lines whose deflection rounds to this step.
std::vector<Polyline> lines_of_step(const DeformedShape& shape, int step) {
  std::vector<Polyline> out;
  for (std::size_t i = 0; i < shape.moved.size(); ++i) {
    const double value = shape.values.empty() ? 1 : shape.values[i];
    if (std::lround(value * kColourSteps) == step) out.push_back(shape.moved[i]);
  }
  return out;
}

}  // namespace

SvgFragment shape_svg(const std::string& title, const std::vector<DeformedShape>& drawings) {
  Box box;
  for (const DeformedShape& drawing : drawings) {
    box.cover(drawing.rest);
    box.cover(drawing.moved);
  }
  const std::size_t beside = std::clamp<std::size_t>(drawings.size(), 1, kPerRow);
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
    for (int step = -kColourSteps; step <= kColourSteps; ++step) {
      const std::string ink = fmt::format(R"(stroke="{}" stroke-width="2" stroke-linecap="round")", colour_of(step));
      draw(lines_of_step(drawings[i], step), box, left, top, ink.c_str(), piece.body);
    }
    for (const DeformedShape::Sign& sign : drawings[i].signs) {
      const auto [x, y] = box.place(sign.at, left, top);
      fmt::format_to(
          std::back_inserter(piece.body),
          R"(<text x="{:.1f}" y="{:.1f}" text-anchor="middle" dominant-baseline="central" font-weight="bold" )"
          R"(stroke="white" stroke-width="3" paint-order="stroke">{}</text>)"
          "\n",
          x, y, sign.positive ? "+" : "−");
    }
    fmt::format_to(std::back_inserter(piece.body),
                   R"(<text x="{:.1f}" y="{:.1f}" text-anchor="middle">{}</text>)"
                   "\n",
                   left + kCell / 2, top + kCell + 12, svg_escape(drawings[i].name));
  }
  return piece;
}

}  // namespace percuss::report
