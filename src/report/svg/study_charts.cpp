#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "core/math/statistics.hpp"
#include "report/svg/line_chart.hpp"
#include "report/svg/study_charts.hpp"

namespace percuss::report {
namespace {

// The first three marks for hollow bats are the marks of source [8]: plus signs, open diamonds, and solid diamonds for
// bats that are broken in.
struct BatKind {
  const char* name;
  ChartMark mark;
};
constexpr std::array<BatKind, 5> kBatKinds{{{"aluminum", ChartMark::plus},
                                            {"composite", ChartMark::open_diamond},
                                            {"composite, ABI", ChartMark::diamond},
                                            {"BBCOR program", ChartMark::square},
                                            {"aluminum, used", ChartMark::triangle}}};
constexpr std::array<ChartMark, 7> kLengthMarks{ChartMark::circle,  ChartMark::plus,     ChartMark::open_diamond,
                                                ChartMark::diamond, ChartMark::triangle, ChartMark::square,
                                                ChartMark::cross};
constexpr std::size_t kModelStyle = 0;  // the only solid curve
constexpr std::array<std::size_t, 4> kTrendStyles{4, 5, 6, 3};

std::size_t kind_of(const metrics::StudyBat& bat) {
  if (bat.program == "bbcor") return 3;
  if (bat.material == metrics::BarrelMaterial::composite) return bat.broken_in ? 2 : 1;
  return bat.broken_in ? 4 : 0;
}

const metrics::StudyClass& pooled_class(const metrics::StudyFigure& figure) { return figure.classes.back(); }

void add_point(ChartCurve& curve, const metrics::Study& study, const metrics::StudyFigure& figure, std::size_t b) {
  curve.x.push_back(*study.bats[b].value(figure.x));
  curve.y.push_back(*study.bats[b].value(figure.y));
  const bool outlier = std::any_of(figure.classes.begin(), figure.classes.end(), [&](const metrics::StudyClass& one) {
    return std::find(one.outliers.begin(), one.outliers.end(), b) != one.outliers.end();
  });
  curve.labels.push_back(outlier ? study.bats[b].id : "");
}

std::vector<ChartCurve> curves_by_length(const metrics::Study& study, const metrics::StudyFigure& figure) {
  std::vector<ChartCurve> out;
  for (const metrics::StudyClass& one : figure.classes) {
    if (one.length_class == 0) continue;
    ChartCurve curve{.name = fmt::format("{} in", one.length_class),
                     .line = false,
                     .mark = kLengthMarks.at(out.size() % kLengthMarks.size()),
                     .style = out.size()};
    for (const std::size_t b : one.bats) add_point(curve, study, figure, b);
    out.push_back(std::move(curve));
  }
  return out;
}

std::vector<ChartCurve> curves_by_kind(const metrics::Study& study, const metrics::StudyFigure& figure) {
  std::vector<ChartCurve> out;
  for (std::size_t kind = 0; kind < kBatKinds.size(); ++kind) {
    ChartCurve curve{.name = kBatKinds.at(kind).name,
                     .line = false,
                     .mark = kBatKinds.at(kind).mark,
                     .style = kind < 3 ? kind : kind + 2};
    for (const std::size_t b : pooled_class(figure).bats) {
      if (kind_of(study.bats[b]) == kind) add_point(curve, study, figure, b);
    }
    if (!curve.x.empty()) out.push_back(std::move(curve));
  }
  return out;
}

// Adds the trend of each length class, from the smallest x of the class to its largest.
void add_trends(const metrics::Study& study, const metrics::StudyFigure& figure, bool by_length,
                std::vector<ChartCurve>& curves) {
  std::size_t place = 0;
  for (const metrics::StudyClass& one : figure.classes) {
    if (one.length_class == 0) continue;
    const std::size_t style = by_length ? place : kTrendStyles.at(place % kTrendStyles.size());
    ++place;
    if (!one.trend) continue;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const std::size_t b : one.bats) {
      low = std::min(low, *study.bats[b].value(figure.x));
      high = std::max(high, *study.bats[b].value(figure.x));
    }
    const auto at = [&](double x) { return one.trend->at + one.trend->slope * x; };
    curves.push_back({.name = fmt::format("trend, {} in", one.length_class),
                      .x = {low, high},
                      .y = {at(low), at(high)},
                      .style = style});
  }
}

double value_at(const metrics::StudyCurve& curve, double hoop_Hz) {
  const auto above = std::lower_bound(curve.hoop_Hz.begin(), curve.hoop_Hz.end(), hoop_Hz);
  if (above == curve.hoop_Hz.end() || above == curve.hoop_Hz.begin()) return std::numeric_limits<double>::quiet_NaN();
  const auto i = static_cast<std::size_t>(above - curve.hoop_Hz.begin());
  const double part = (hoop_Hz - curve.hoop_Hz[i - 1]) / (curve.hoop_Hz[i] - curve.hoop_Hz[i - 1]);
  return curve.value[i - 1] + part * (curve.value[i] - curve.value[i - 1]);
}

// The model's curve over the range of the bats, scaled by the median ratio of bat to model.
void add_model(const metrics::StudyCurve& model, std::vector<ChartCurve>& curves) {
  std::vector<double> factors;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const ChartCurve& curve : curves) {
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      const double there = value_at(model, curve.x[i]);
      if (there > 0) factors.push_back(curve.y[i] / there);
      low = std::min(low, curve.x[i]);
      high = std::max(high, curve.x[i]);
    }
  }
  if (factors.empty()) return;
  const double factor = median(factors);
  ChartCurve drawn{.name = fmt::format("{} × {:.3g}", model.name, factor), .style = kModelStyle};
  for (std::size_t i = 0; i < model.hoop_Hz.size(); ++i) {
    if (model.hoop_Hz[i] < low || model.hoop_Hz[i] > high) continue;
    drawn.x.push_back(model.hoop_Hz[i]);
    drawn.y.push_back(factor * model.value[i]);
  }
  curves.push_back(std::move(drawn));
}

LineChart chart_of(const metrics::Study& study, const metrics::StudyFigure& figure,
                   const std::optional<metrics::StudyCurve>& model) {
  const bool by_length = figure.family == metrics::StudyFamily::wood;
  LineChart chart{
      .title = figure.title, .x = {.label = metrics::axis_of(figure.x)}, .y = {.label = metrics::axis_of(figure.y)}};
  chart.curves = by_length ? curves_by_length(study, figure) : curves_by_kind(study, figure);
  const bool hoop = figure.x == metrics::StudyQuantity::hoop1 && model;
  if (hoop) add_model(*model, chart.curves);
  add_trends(study, figure, by_length, chart.curves);
  return chart;
}

std::string points_csv(const metrics::Study& study, metrics::StudyQuantity x, metrics::StudyQuantity y,
                       const std::vector<std::size_t>& bats, CsvFormulas formulas) {
  std::string out =
      fmt::format("id,length_in,material,condition,{},{}\n", metrics::column_of(x), metrics::column_of(y));
  for (const std::size_t b : bats) {
    const metrics::StudyBat& bat = study.bats[b];
    out += fmt::format("{},{},{},{},{},{}\n", csv_cell(bat.id, formulas), bat.length_in, metrics::name_of(bat.material),
                       bat.condition(), *bat.value(x), *bat.value(y));
  }
  return out;
}

// File names contain no characters that are special to a shell or a file system.
std::string file_word(const std::string& text) {
  std::string out;
  for (const char c : text.substr(0, 60)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
    out += plain ? c : '_';
  }
  return out;
}

// The chart of a figure, or of the history of one bat, with the bats that it shows.
struct StudyPlot {
  std::string name;
  std::string source;  // number of the source's figure; empty: it has none
  metrics::StudyQuantity x, y;
  LineChart chart;
  std::vector<std::size_t> bats;
};

void add_history(const metrics::Study& study, const metrics::StudyHistory& history, std::size_t number,
                 metrics::StudyQuantity y, const std::optional<metrics::StudyCurve>& model,
                 std::vector<StudyPlot>& drawn) {
  ChartCurve states{.marks = true, .mark = ChartMark::diamond, .style = 2};
  std::vector<std::size_t> shown;
  for (const std::size_t b : history.states) {
    if (!study.bats[b].value(y)) continue;
    shown.push_back(b);
    states.x.push_back(*study.bats[b].value(metrics::StudyQuantity::hoop1));
    states.y.push_back(*study.bats[b].value(y));
    states.labels.push_back(study.bats[b].id);
  }
  if (shown.size() < 2) return;
  LineChart chart{.title = fmt::format("{}: {} over the break-in", history.bat, metrics::phrase_of(y)),
                  .x = {.label = metrics::axis_of(metrics::StudyQuantity::hoop1)},
                  .y = {.label = metrics::axis_of(y)},
                  .curves = {states}};
  if (model) add_model(*model, chart.curves);
  const std::string column = metrics::column_of(y);
  std::string name =
      fmt::format("{}-hoop1-trail-{}-{}", column.substr(0, column.find('_')), number, file_word(history.bat));
  // The figures of [8] over the break-in.
  const char* const source = y == metrics::StudyQuantity::besr ? "67" : y == metrics::StudyQuantity::bbs ? "68" : "69";
  drawn.push_back({std::move(name), source, metrics::StudyQuantity::hoop1, y, std::move(chart), std::move(shown)});
}

std::vector<StudyPlot> plotted_curves(const metrics::Study& study, const std::optional<metrics::StudyCurve>& model) {
  std::vector<StudyPlot> drawn;
  for (const metrics::StudyFigure& figure : study.figures) {
    drawn.push_back(
        {figure.name, figure.source, figure.x, figure.y, chart_of(study, figure, model), pooled_class(figure).bats});
  }
  for (std::size_t t = 0; t < study.histories.size(); ++t) {
    for (const metrics::StudyQuantity y :
         {metrics::StudyQuantity::besr, metrics::StudyQuantity::bbs, metrics::StudyQuantity::bbcor})
      add_history(study, study.histories[t], t, y, model, drawn);
  }
  return drawn;
}

}  // namespace

std::vector<StudyFile> study_files(const metrics::Study& study, const std::optional<metrics::StudyCurve>& curve,
                                   CsvFormulas formulas) {
  std::vector<StudyFile> files;
  std::string list = "figure,source,bats,title\n";
  for (const StudyPlot& one : plotted_curves(study, curve)) {
    list += fmt::format("{},{},{},{}\n", one.name, one.source, one.bats.size(), csv_cell(one.chart.title, formulas));
    files.push_back({one.name + ".svg", line_chart_svg(one.chart)});
    files.push_back({one.name + ".csv", points_csv(study, one.x, one.y, one.bats, formulas)});
  }
  files.push_back({"figures.csv", std::move(list)});
  return files;
}

std::vector<LineChart> study_charts(const metrics::Study& study, const std::optional<metrics::StudyCurve>& curve) {
  std::vector<LineChart> charts;
  for (StudyPlot& one : plotted_curves(study, curve)) charts.push_back(std::move(one.chart));
  return charts;
}

}  // namespace percuss::report
