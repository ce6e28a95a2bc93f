#include "report/svg/line_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <vector>

#include "report/svg/chart_mark.hpp"
#include "report/svg/chart_path.hpp"
#include "report/svg/chart_scale.hpp"
#include "report/svg/extreme_samples.hpp"
#include "report/text/text_table.hpp"

namespace percuss::report {
namespace {

constexpr double kWidth = 760, kHeight = 440;
constexpr double kLeft = 72, kRight = 620, kTop = 44, kBottom = 384;  // of the plot; the curves' names are to its right
constexpr double kLineHeight = 15, kCharacterWidth = 7;               // at most
constexpr double kFlagCharacterWidth = 6.4;                           // on average
constexpr double kLabelRoom = 20;                                     // right of a point, for its label
constexpr double kAxisLabel = 18;                                     // middle of the label of the y axis
constexpr double kTickGap = 6;                                        // between a tick value and the plot
constexpr std::size_t kLongestName = 48;
constexpr std::size_t kTicks = 6;

// Five colours of Okabe and Ito that are dark enough for a line, and two others; each with a dash pattern.
constexpr std::array<const char*, 7> kColours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                              "#000000", "#5B3A8C", "#7A5C00"};
// Darker variants for text.
constexpr std::array<const char*, 7> kLetterColours{"#0072B2", "#B34700", "#00704F", "#8A3A73",
                                                    "#000000", "#5B3A8C", "#7A5C00"};
constexpr std::array<const char*, 7> kPageColours{"var(--c0)", "var(--c1)", "var(--c2)", "var(--c3)",
                                                  "var(--c7)", "var(--c5)", "var(--c4)"};
constexpr std::array<const char*, 7> kDashes{"none", "7 3", "2 3", "9 3 2 3", "12 4", "4 2", "6 2 1 2 1 2"};

// Shortened to the room available.
std::string shown_name(const std::string& name) {
  if (text_width(name) <= kLongestName) return name;
  std::string out;
  std::size_t characters = 0;
  for (const char c : name) {
    if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U && ++characters == kLongestName) break;
    out += c;
  }
  return out + "…";
}

class Drawing {
 public:
  Drawing(const LineChart& chart, ChartTheme theme)
      : chart_(chart), on_page_(theme == ChartTheme::page), grid_(on_page_ ? "var(--rule)" : "#ddd") {
    x_ = {.from = kLeft, .to = kRight, .logarithmic = chart.x.logarithmic};
    y_ = {.from = kBottom, .to = kTop, .logarithmic = chart.y.logarithmic};
    std::size_t longest = 0;
    for (const ChartCurve& curve : chart.curves) {
      for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (!std::isfinite(y_.drawn(curve.y[i]))) continue;
        x_.cover(curve.x[i]);
        y_.cover(curve.y[i]);
      }
      longest = std::max(longest, text_width(shown_name(curve.name)));
    }
    scattered_ = std::any_of(chart.curves.begin(), chart.curves.end(), [](const auto& curve) { return !curve.line; });
    const bool room = std::any_of(chart.curves.begin(), chart.curves.end(),
                                  [](const auto& curve) { return !curve.line || !curve.labels.empty(); });
    fit(x_, chart.x, room ? 0.04 : 0);
    fit(y_, chart.y, 0.04);
    y_ticks_ = chart.y.ticks.empty() ? y_.ticks(kTicks) : chart.y.ticks;
    std::size_t widest = 0;
    for (const double tick : y_ticks_) widest = std::max(widest, text_width(fmt::format("{:.6g}", tick)));
    const double of_ticks = kTickGap + kCharacterWidth * static_cast<double>(widest);
    shift_ = std::max(0.0, kAxisLabel + kLineHeight / 2 + kTickGap + of_ticks - kLeft);
    width_ =
        shift_ + std::max(kWidth, kRight + (scattered_ ? 34 : 12) + kCharacterWidth * static_cast<double>(longest));
  }

  SvgFragment piece() {
    add("<title>{}</title>\n", svg_escape(chart_.title));
    if (!on_page_) add("<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n");
    if (shift_ > 0) add("<g transform=\"translate({} 0)\">\n", shift_);
    add("<text x=\"{}\" y=\"18\" font-size=\"15\">{}</text>\n", kLeft, svg_escape(chart_.title));
    axes();
    for (const ChartBand& one : chart_.bands) band(one);
    for (std::size_t i = 0; i < chart_.curves.size(); ++i) {
      const ChartCurve& curve = chart_.curves[i];
      if (curve.line) line(curve, style_of(i));
      if (curve.marks || !curve.line) points(curve, style_of(i));
    }
    flags();
    scattered_ ? legend() : names();
    if (shift_ > 0) add("</g>\n");
    return {.body = out_, .width = width_, .height = kHeight, .ink = ink()};
  }

 private:
  template <class... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
  }

  static void fit(ChartScale& scale, const ChartAxis& axis, double margin) {
    if (!axis.range) return scale.settle(margin);
    scale.low = scale.drawn(axis.range->first);
    scale.high = scale.drawn(axis.range->second);
  }

  const char* ink() const { return on_page_ ? "var(--ink)" : "black"; }
  const char* colour(std::size_t style) const { return on_page_ ? kPageColours.at(style) : kColours.at(style); }
  const char* letters(std::size_t style) const { return on_page_ ? colour(style) : kLetterColours.at(style); }
  std::size_t style_of(std::size_t i) const { return chart_.curves[i].style.value_or(i) % kColours.size(); }

  void axes() {
    for (const double tick : chart_.x.ticks.empty() ? x_.ticks(kTicks) : chart_.x.ticks) {
      const double at = x_.pixel(tick);
      add("<path d=\"M{:.1f} {}V{}\" stroke=\"{}\"/><text x=\"{:.1f}\" y=\"{}\" "
          "text-anchor=\"middle\">{:.6g}</text>\n",
          at, kTop, kBottom, grid_, at, kBottom + 18, tick);
    }
    for (const double tick : y_ticks_) {
      const double at = y_.pixel(tick);
      add("<path d=\"M{} {:.1f}H{}\" stroke=\"{}\"/><text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{:.6g}</text>\n",
          kLeft, at, kRight, grid_, kLeft - kTickGap, at + 4, tick);
    }
    add("<path d=\"M{} {}V{}H{}\" fill=\"none\" stroke=\"{}\"/>\n", kLeft, kTop, kBottom, kRight, ink());
    add("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", (kLeft + kRight) / 2, kBottom + 40,
        svg_escape(chart_.x.label));
    add("<text transform=\"translate({} {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n", kAxisLabel - shift_,
        (kTop + kBottom) / 2, svg_escape(chart_.y.label));
  }

  void line(const ChartCurve& curve, std::size_t style) {
    add("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-dasharray=\"{}\"/>\n",
        path_through({x_, y_}, curve.x, curve.y), curve.thin ? ink() : colour(style), curve.thin ? 0.8 : 1.8,
        curve.thin ? "none" : kDashes.at(style));
  }

  void band(const ChartBand& one) {
    add("<path d=\"{}\" fill=\"{}\" fill-opacity=\"0.2\"/>\n", path_around({x_, y_}, one),
        colour(one.style % kColours.size()));
  }

  void points(const ChartCurve& curve, std::size_t style) {
    std::vector<std::size_t> drawn(curve.x.size());
    std::iota(drawn.begin(), drawn.end(), std::size_t{0});
    if (curve.line) drawn = extreme_samples(curve.y);
    for (const std::size_t i : drawn) {
      const double x = x_.pixel(curve.x[i]), y = y_.pixel(curve.y[i]);
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      out_ += chart_mark_svg(curve.mark, x, y, colour(style));
      if (i < curve.labels.size() && !curve.labels[i].empty()) label(curve.labels[i], x, y);
    }
    out_ += '\n';
  }

  // The room of a text: its left end, its right end and its base line.
  struct TextPlace {
    double left = 0, right = 0, y = 0;
    bool overlaps(const TextPlace& other) const {
      return left < other.right && other.left < right && std::abs(y - other.y) < kLineHeight - 1;
    }
  };

  // A label beside its point, higher or lower where it would lie over another; none where there is no room.
  void label(const std::string& text, double x, double y) {
    const double width = kFlagCharacterWidth * static_cast<double>(text_width(text));
    const bool before = x > kRight - kLabelRoom || (x + 7 + width > kRight && x - 7 - width > kLeft);
    const double left = before ? x - 7 - width : x + 7;
    for (const int line : {0, -1, 1, -2, 2, -3, 3}) {
      const TextPlace place{.left = left, .right = left + width, .y = y - 5 + kLineHeight * line};
      const bool inside = line == 0 || (place.y > kTop && place.y < kBottom);
      const auto overlaps = [&](const TextPlace& other) { return place.overlaps(other); };
      if (!inside || std::any_of(labels_.begin(), labels_.end(), overlaps)) continue;
      labels_.push_back(place);
      add(R"(<text x="{:.1f}" y="{:.1f}"{}>{}</text>)", before ? x - 7 : x + 7, place.y,
          before ? " text-anchor=\"end\"" : "", svg_escape(text));
      return;
    }
  }

  // Names above the plot, unless they overlap the name before.
  void flags() {
    double free = kLeft - kLabelRoom;
    for (const ChartAnnotation& flag : chart_.flags) {
      const double at = x_.pixel(flag.x);
      if (!(at >= kLeft && at <= kRight)) continue;
      add(R"(<path d="M{:.1f} {}V{}" stroke="{}" stroke-dasharray="2 3"/>)", at, kTop, kBottom, ink());
      const double half = 0.5 * kFlagCharacterWidth * static_cast<double>(text_width(flag.name));
      if (at - half < free) continue;
      add(R"(<text x="{:.1f}" y="{}" text-anchor="middle">{}</text>)", at, kTop - 6, svg_escape(flag.name));
      free = at + half + kFlagCharacterWidth;
    }
    out_ += '\n';
  }

  void legend() {
    double y = kTop + 6;
    for (std::size_t i = 0; i < chart_.curves.size(); ++i) {
      const ChartCurve& curve = chart_.curves[i];
      if (curve.name.empty()) continue;
      const std::size_t style = style_of(i);
      if (curve.line) {
        add(R"(<path d="M{} {:.1f}h20" stroke="{}" stroke-width="1.8" stroke-dasharray="{}"/>)", kRight + 6, y,
            colour(style), kDashes.at(style));
      }
      if (curve.marks || !curve.line) out_ += chart_mark_svg(curve.mark, kRight + 16, y, colour(style));
      add("<text x=\"{}\" y=\"{:.1f}\">{}</text>\n", kRight + 30, y + 4, svg_escape(shown_name(curve.name)));
      y += kLineHeight + 2;
    }
  }

  // Names at the ends of the curves, moved apart where they would overlap.
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
      add("<text x=\"{}\" y=\"{:.1f}\" fill=\"{}\">{}</text>\n", kRight + 8, y + 4,
          chart_.curves[i].thin ? ink() : letters(style_of(i)), svg_escape(shown_name(chart_.curves[i].name)));
    }
  }

  const LineChart& chart_;
  bool on_page_;
  const char* grid_;
  ChartScale x_, y_;
  double width_ = kWidth;
  std::vector<double> y_ticks_;
  double shift_ = 0;  // of everything to the right, for wide tick values of y
  bool scattered_ = false;
  std::vector<TextPlace> labels_;  // placed so far
  std::string out_;
};

}  // namespace

SvgFragment line_chart_fragment(const LineChart& chart, ChartTheme theme) { return Drawing(chart, theme).piece(); }

std::string line_chart_svg(const LineChart& chart, ChartTheme theme) {
  return svg_document({line_chart_fragment(chart, theme)});
}

std::string line_charts_svg(const std::vector<LineChart>& charts) {
  std::vector<SvgFragment> pieces;
  pieces.reserve(charts.size());
  for (const LineChart& chart : charts) pieces.push_back(line_chart_fragment(chart));
  return svg_document(pieces);
}

}  // namespace percuss::report
