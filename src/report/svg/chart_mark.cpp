#include "report/svg/chart_mark.hpp"

#include <fmt/format.h>

namespace percuss::report {
namespace {

constexpr double kHalfMarkSize = 3.6;

}  // namespace

std::string chart_mark_svg(ChartMark mark, double x, double y, const char* colour) {
  const double r = kHalfMarkSize;
  const std::string filled = fmt::format("fill=\"{}\"", colour);
  const std::string drawn = fmt::format(R"(fill="none" stroke="{}" stroke-width="1.5")", colour);
  const auto path = [&](const std::string& way, const std::string& ink) {
    return fmt::format("<path d=\"M{:.1f} {:.1f}{}\" {}/>", x, y, way, ink);
  };
  switch (mark) {
    case ChartMark::plus:
      return path(fmt::format("m-{0} 0h{1}m-{0} -{0}v{1}", r, 2 * r), drawn);
    case ChartMark::cross:
      return path(fmt::format("m-{0} -{0}l{1} {1}m0 -{1}l-{1} {1}", r, 2 * r), drawn);
    case ChartMark::open_diamond:
      return path(fmt::format("m0 -{0}l{0} {0}l-{0} {0}l-{0} -{0}z", r + 0.6), drawn);
    case ChartMark::diamond:
      return path(fmt::format("m0 -{0}l{0} {0}l-{0} {0}l-{0} -{0}z", r + 0.6), filled);
    case ChartMark::triangle:
      return path(fmt::format("m0 -{0}l{0} {1}h-{1}z", r, 2 * r), filled);
    case ChartMark::square:
      return path(fmt::format("m-{0} -{0}h{1}v{1}h-{1}z", r - 0.4, 2 * r - 0.8), filled);
    case ChartMark::circle:
      break;
  }
  return fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="3" {}/>)", x, y, filled);
}

std::string svg_escape(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '&') {
      out += "&amp;";
    } else {
      out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return out;
}

}  // namespace percuss::report
