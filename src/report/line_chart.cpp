#include "report/line_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "report/chart_mark.hpp"

namespace percuss {
namespace {

constexpr double kWidth = 760, kHeight = 440;
constexpr double kLeft = 72, kRight = 620, kTop = 44, kBottom = 384;  // of the plot; names stand right of it
constexpr double kLineHeight = 15;
constexpr double kLabelRoom = 20;  // right of a point, for its label
constexpr std::size_t kMostDrawn = 1000;
constexpr std::size_t kTicks = 6;

// Okabe and Ito's colours without yellow, which is too pale for a line; a dash pattern with each.
struct Stroke {
  const char* colour;
  const char* dashes;
};
constexpr std::array<Stroke, 7> kStrokes{{{"#0072B2", "none"},
                                          {"#D55E00", "7 3"},
                                          {"#009E73", "2 3"},
                                          {"#CC79A7", "9 3 2 3"},
                                          {"#000000", "12 4"},
                                          {"#5B3A8C", "4 2"},
                                          {"#7A5C00", "6 2 1 2 1 2"}}};

// Values to pixels along one axis.
struct Scale {
  double low = std::numeric_limits<double>::infinity(), high = -low;  // of the values, logarithms where so drawn
  double from = 0, to = 1;                                            // pixels
  bool logarithmic = false;

  double drawn(double value) const { return logarithmic ? std::log10(value) : value; }
  void cover(double value) {
    if (!std::isfinite(drawn(value))) return;
    low = std::min(low, drawn(value));
    high = std::max(high, drawn(value));
  }
  void settle(double margin) {
    if (!(high >= low)) low = 0, high = 1;
    const double width = high > low ? high - low : std::max(1e-3, 0.02 * std::abs(high));
    low -= margin * width;
    high += margin * width;
    if (!(high > low)) high = low + width;
  }
  double pixel(double value) const { return from + (drawn(value) - low) / (high - low) * (to - from); }
  std::vector<double> ticks() const {
    if (!logarithmic) return round_ticks(low, high, kTicks);
    std::vector<double> all;
    for (auto decade = static_cast<int>(std::ceil(low - 1)); decade <= high; ++decade) {
      for (const double factor : {1.0, 2.0, 5.0}) {
        const double value = factor * std::pow(10, decade);
        if ((factor == 1 || high - low < 2) && drawn(value) >= low && drawn(value) <= high) all.push_back(value);
      }
    }
    return all;
  }
};

// Of each run of neighbours the lowest and the highest, in their order.
std::vector<std::size_t> worth_drawing(const ChartCurve& curve) {
  std::vector<std::size_t> kept;
  const std::size_t run = std::max<std::size_t>(1, 2 * curve.x.size() / kMostDrawn);
  for (std::size_t begin = 0; begin < curve.x.size(); begin += run) {
    const std::size_t end = std::min(begin + run, curve.x.size());
    std::size_t low = begin, high = begin;
    for (std::size_t i = begin; i < end; ++i) {
      if (curve.y[i] < curve.y[low]) low = i;
      if (curve.y[i] > curve.y[high]) high = i;
    }
    kept.push_back(std::min(low, high));
    if (low != high) kept.push_back(std::max(low, high));
  }
  return kept;
}

class Drawing {
 public:
  explicit Drawing(const LineChart& chart) : chart_(chart) {
    x_ = {.from = kLeft, .to = kRight, .logarithmic = chart.x.logarithmic};
    y_ = {.from = kBottom, .to = kTop, .logarithmic = chart.y.logarithmic};
    for (const ChartCurve& curve : chart.curves) {
      for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (!std::isfinite(y_.drawn(curve.y[i]))) continue;
        x_.cover(curve.x[i]);
        y_.cover(curve.y[i]);
      }
    }
    scattered_ = std::any_of(chart.curves.begin(), chart.curves.end(), [](const auto& curve) { return !curve.line; });
    const bool room = std::any_of(chart.curves.begin(), chart.curves.end(),
                                  [](const auto& curve) { return !curve.line || !curve.labels.empty(); });
    x_.settle(room ? 0.04 : 0);
    y_.settle(0.04);
  }

  std::string text() {
    add("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" width=\"{}\" height=\"{}\" "
        "font-family=\"system-ui, sans-serif\" font-size=\"12\" role=\"img\">\n",
        kWidth, kHeight, kWidth, kHeight);
    add("<title>{}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n", svg_text(chart_.title));
    add("<text x=\"{}\" y=\"24\" font-size=\"15\">{}</text>\n", kLeft, svg_text(chart_.title));
    axes();
    for (std::size_t i = 0; i < chart_.curves.size(); ++i) {
      const ChartCurve& curve = chart_.curves[i];
      if (curve.line) line(curve, stroke_of(i));
      if (curve.marks || !curve.line) points(curve, stroke_of(i));
    }
    scattered_ ? legend() : names();
    return out_ + "</svg>\n";
  }

 private:
  template <class... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
  }

  void axes() {
    for (const double tick : x_.ticks()) {
      const double at = x_.pixel(tick);
      add("<path d=\"M{:.1f} {}V{}\" stroke=\"#ddd\"/><text x=\"{:.1f}\" y=\"{}\" "
          "text-anchor=\"middle\">{:.6g}</text>\n",
          at, kTop, kBottom, at, kBottom + 18, tick);
    }
    for (const double tick : y_.ticks()) {
      const double at = y_.pixel(tick);
      add("<path d=\"M{} {:.1f}H{}\" stroke=\"#ddd\"/><text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{:.6g}</text>\n",
          kLeft, at, kRight, kLeft - 6, at + 4, tick);
    }
    add("<path d=\"M{} {}V{}H{}\" fill=\"none\" stroke=\"black\"/>\n", kLeft, kTop, kBottom, kRight);
    add("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", (kLeft + kRight) / 2, kBottom + 40,
        svg_text(chart_.x.label));
    add("<text transform=\"translate(18 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n", (kTop + kBottom) / 2,
        svg_text(chart_.y.label));
  }

  const Stroke& stroke_of(std::size_t i) const {
    return kStrokes.at(chart_.curves[i].style.value_or(i) % kStrokes.size());
  }

  void line(const ChartCurve& curve, const Stroke& stroke) {
    std::string path;
    bool pen = false;
    for (const std::size_t i : worth_drawing(curve)) {
      const double x = x_.pixel(curve.x[i]), y = y_.pixel(curve.y[i]);
      if (!std::isfinite(x) || !std::isfinite(y)) {
        pen = false;
        continue;
      }
      fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", pen ? "L" : "M", x, y);
      pen = true;
    }
    add("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.8\" stroke-dasharray=\"{}\"/>\n", path,
        stroke.colour, stroke.dashes);
  }

  void points(const ChartCurve& curve, const Stroke& stroke) {
    std::vector<std::size_t> drawn(curve.x.size());
    std::iota(drawn.begin(), drawn.end(), std::size_t{0});
    if (curve.line) drawn = worth_drawing(curve);
    for (const std::size_t i : drawn) {
      const double x = x_.pixel(curve.x[i]), y = y_.pixel(curve.y[i]);
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      out_ += chart_mark_svg(curve.mark, x, y, stroke.colour);
      if (i < curve.labels.size() && !curve.labels[i].empty()) {
        add(R"(<text x="{:.1f}" y="{:.1f}"{}>{}</text>)", x > kRight - kLabelRoom ? x - 7 : x + 7, y - 5,
            x > kRight - kLabelRoom ? " text-anchor=\"end\"" : "", svg_text(curve.labels[i]));
      }
    }
    out_ += '\n';
  }

  void legend() {
    double y = kTop + 6;
    for (std::size_t i = 0; i < chart_.curves.size(); ++i) {
      const ChartCurve& curve = chart_.curves[i];
      if (curve.name.empty()) continue;
      const Stroke& stroke = stroke_of(i);
      if (curve.line) {
        add(R"(<path d="M{} {:.1f}h20" stroke="{}" stroke-width="1.8" stroke-dasharray="{}"/>)", kRight + 6, y,
            stroke.colour, stroke.dashes);
      }
      if (curve.marks || !curve.line) out_ += chart_mark_svg(curve.mark, kRight + 16, y, stroke.colour);
      add("<text x=\"{}\" y=\"{:.1f}\">{}</text>\n", kRight + 30, y + 4, svg_text(curve.name));
      y += kLineHeight + 2;
    }
  }

  // At the ends of the lines, moved apart where they would overlap.
  void names() {
    std::vector<std::pair<double, std::size_t>> ends;
    for (std::size_t i = 0; i < chart_.curves.size(); ++i) {
      const auto& y = chart_.curves[i].y;
      const auto last =
          std::find_if(y.rbegin(), y.rend(), [&](double value) { return std::isfinite(y_.drawn(value)); });
      if (last != y.rend() && !chart_.curves[i].name.empty()) ends.emplace_back(y_.pixel(*last), i);
    }
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 1; i < ends.size(); ++i)
      ends[i].first = std::max(ends[i].first, ends[i - 1].first + kLineHeight);
    double limit = kBottom;
    for (std::size_t i = ends.size(); i-- > 0;) {
      ends[i].first = std::min(ends[i].first, limit);
      limit = ends[i].first - kLineHeight;
    }
    for (const auto& [y, i] : ends) {
      add("<text x=\"{}\" y=\"{:.1f}\" fill=\"{}\">{}</text>\n", kRight + 8, y + 4, stroke_of(i).colour,
          svg_text(chart_.curves[i].name));
    }
  }

  const LineChart& chart_;
  Scale x_, y_;
  bool scattered_ = false;
  std::string out_;
};

}  // namespace

std::vector<double> round_ticks(double low, double high, std::size_t wanted) {
  if (!(high > low) || wanted == 0 || !std::isfinite(high - low)) return {};
  const double raw = (high - low) / static_cast<double>(wanted);
  const double power = std::pow(10, std::floor(std::log10(raw)));
  const double lead = raw / power;
  const double step = power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
  std::vector<double> ticks;
  const double first = std::ceil(low / step - 1e-9), last = std::floor(high / step + 1e-9);
  for (std::size_t i = 0; first + static_cast<double>(i) <= last; ++i)
    ticks.push_back((first + static_cast<double>(i)) * step);
  return ticks;
}

std::string line_chart_svg(const LineChart& chart) { return Drawing(chart).text(); }

}  // namespace percuss
