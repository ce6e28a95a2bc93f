#include "report/compare_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "report/compare_text.hpp"
#include "report/json/compare_json.hpp"
#include "report/text/number_format.hpp"

namespace percuss::report {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// A column for a value of every mode of the first document; NaN where it is unknown.
NumericColumn column_of(const std::string& name, std::size_t modes,
                        const std::function<std::optional<double>(std::size_t mode)>& value) {
  NumericColumn column{.name = name, .values = {}};
  for (std::size_t m = 0; m < modes; ++m) column.values.push_back(value(m).value_or(kNone));
  return column;
}

// The modes of the first document, and their partners in the other documents.
std::vector<NumericColumn> mode_columns(const std::vector<metrics::ComparedDocument>& documents,
                                        const std::vector<Comparison>& comparisons) {
  const metrics::ComparedDocument& first = documents.front();
  const std::size_t count = first.modes.size();
  const auto of_first = [&](const std::string& name, auto value) {
    return column_of(name, count, [&](std::size_t m) { return std::optional<double>(value(m)); });
  };
  std::vector<NumericColumn> columns{
      of_first("mode", [&](std::size_t m) { return static_cast<double>(first_mode_number(first) + m); }),
      of_first("frequency_1_hz", [&](std::size_t m) { return first.modes[m].freq_Hz; }),
      of_first("frequency_std_1_hz", [&](std::size_t m) { return first.modes[m].freq_std_Hz; }),
      of_first("damping_ratio_1", [&](std::size_t m) { return first.modes[m].damping_ratio.value_or(kNone); })};
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    const Comparison& c = comparisons[i];
    const auto of_pair = [&](const char* name, auto value) {
      columns.push_back(column_of(fmt::format(fmt::runtime(name), i + 2), count, [&](std::size_t m) {
        const metrics::ModePair* pair = pair_at(c, m);
        return pair ? std::optional<double>(value(*pair)) : std::nullopt;
      }));
    };
    of_pair("frequency_{}_hz", [&](const metrics::ModePair& pair) { return c.b.modes[pair.b].freq_Hz; });
    of_pair("difference_{}_percent", [](const metrics::ModePair& pair) { return pair.difference_percent; });
    of_pair("difference_std_{}_percent",
            [](const metrics::ModePair& pair) { return pair.difference_std_percent.value_or(kNone); });
    of_pair("damping_ratio_{}",
            [&](const metrics::ModePair& pair) { return c.b.modes[pair.b].damping_ratio.value_or(kNone); });
    of_pair("damping_difference_{}_percent",
            [](const metrics::ModePair& pair) { return pair.damping_difference_percent.value_or(kNone); });
    of_pair("damping_difference_std_{}_percent",
            [](const metrics::ModePair& pair) { return pair.damping_difference_std_percent.value_or(kNone); });
    of_pair("mac_{}", [](const metrics::ModePair& pair) { return pair.mac ? pair.mac->value : kNone; });
  }
  return columns;
}

std::vector<NumericColumn> columns_of(const std::vector<metrics::ComparedDocument>& documents,
                                      const std::vector<Comparison>& comparisons) {
  std::vector<NumericColumn> columns = mode_columns(documents, comparisons);
  std::vector<NumericColumn> places{{.name = "position_m", .values = {}}, {.name = "point", .values = {}},
                                    {.name = "peak_1_m", .values = {}},   {.name = "peak_2_m", .values = {}},
                                    {.name = "ratio", .values = {}},      {.name = "ratio_std", .values = {}}};
  for (NumericColumn& column : places) column.values.assign(documents.front().modes.size(), kNone);
  for (const metrics::DeflectionPair& pair : comparisons.front().deflections) {
    for (NumericColumn& column : columns) column.values.push_back(kNone);
    const std::array row{pair.position_m.value_or(kNone),
                         pair.point ? *pair.point : kNone,
                         pair.a_m,
                         pair.b_m,
                         pair.ratio,
                         pair.ratio_std};
    for (std::size_t i = 0; i < row.size(); ++i) places[i].values.push_back(row.at(i));
  }
  if (!comparisons.front().deflections.empty()) columns.insert(columns.end(), places.begin(), places.end());
  return columns;
}

// The families and orders of the modes and of their partners ("bending 3a"), and what paired them; empty in the rows of
// deflections.
std::vector<WordColumn> words_of(const std::vector<metrics::ComparedDocument>& documents,
                                 const std::vector<Comparison>& comparisons) {
  const metrics::ComparedDocument& first = documents.front();
  const std::size_t rows = first.modes.size() + comparisons.front().deflections.size();
  const auto column = [&](const std::string& name, auto word) {
    WordColumn out{.name = name, .values = std::vector<std::string>(rows)};
    for (std::size_t m = 0; m < first.modes.size(); ++m) out.values[m] = word(m);
    return out;
  };
  std::vector<WordColumn> words{column("mode_1", [&](std::size_t m) { return compared_mode_name(first, m); })};
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    const Comparison& c = comparisons[i];
    words.push_back(column(fmt::format("mode_{}", i + 2), [&](std::size_t m) {
      const metrics::ModePair* pair = pair_at(c, m);
      return pair ? compared_mode_name(c.b, pair->b) : "";
    }));
    words.push_back(column(fmt::format("paired_by_{}", i + 2), [&](std::size_t m) {
      const metrics::ModePair* pair = pair_at(c, m);
      return std::string(pair ? name_of(pair->by) : "");
    }));
  }
  return words;
}

// The MAC of every mode of the first document with every mode of the second; nothing without common shapes.
std::optional<MacMatrix> mac_matrix_of(const Comparison& c) {
  MacMatrix out{.caption = fmt::format("rows: {}; columns: {}", one_line(c.a.name, 200), one_line(c.b.name, 200)),
                .rows = {},
                .columns = {},
                .values = {}};
  bool any = false;
  for (const metrics::ComparedMode& mode : c.b.modes) out.columns.push_back(hertz_text(mode.freq_Hz) + " Hz");
  for (const metrics::ComparedMode& mode : c.a.modes) {
    out.rows.push_back(hertz_text(mode.freq_Hz) + " Hz");
    out.values.emplace_back();
    for (const metrics::ComparedMode& other : c.b.modes) {
      const auto mac = metrics::mac_between(mode, other);
      any = any || mac;
      out.values.back().push_back(mac ? std::optional(mac->value) : std::nullopt);
    }
  }
  return any ? std::optional(std::move(out)) : std::nullopt;
}

LineChart compared_deflections_chart(const Comparison& c) {
  // One scale for all: places in a document may have a position, or a point, or both.
  const auto all_have = [&](auto member) {
    return std::all_of(c.deflections.begin(), c.deflections.end(),
                       [&](const metrics::DeflectionPair& pair) { return (pair.*member).has_value(); });
  };
  const bool positions = all_have(&metrics::DeflectionPair::position_m);
  const bool points = all_have(&metrics::DeflectionPair::point);
  LineChart chart{.title = "Largest deflection",
                  .x = {.label = positions ? "position, m"
                                 : points  ? "point"
                                           : "place in the table"},
                  .y = {.label = "largest deflection, mm"},
                  .curves = {}};
  ChartCurve a{.name = c.a.name, .marks = true}, b{.name = c.b.name, .marks = true};
  for (const metrics::DeflectionPair& pair : c.deflections) {
    const double place = positions ? *pair.position_m : points ? *pair.point : 1 + static_cast<double>(a.x.size());
    for (ChartCurve* curve : {&a, &b}) curve->x.push_back(place);
    a.y.push_back(1000 * pair.a_m);
    b.y.push_back(1000 * pair.b_m);
  }
  chart.curves = {a, b};
  return chart;
}

LineChart compared_frequencies_chart(const std::vector<Comparison>& comparisons) {
  LineChart chart{.title = "Frequencies against " + comparisons.front().a.name,
                  .x = {.label = "frequency, Hz"},
                  .y = {.label = "difference, % (band: ± 1 σ)"},
                  .curves = {}};
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const Comparison& c : comparisons) {
    ChartCurve curve{.name = c.b.name, .marks = true};
    ChartBand band{.x = {}, .low = {}, .high = {}, .style = chart.curves.size()};
    for (const metrics::ModePair& pair : c.modes.pairs) {
      const double std = pair.difference_std_percent.value_or(0);
      curve.x.push_back(c.a.modes[pair.a].freq_Hz);
      curve.y.push_back(pair.difference_percent);
      band.x.push_back(curve.x.back());
      band.low.push_back(pair.difference_percent - std);
      band.high.push_back(pair.difference_percent + std);
      lowest = std::min(lowest, band.low.back());
      highest = std::max(highest, band.high.back());
    }
    chart.curves.push_back(std::move(curve));
    chart.bands.push_back(std::move(band));
  }
  if (std::max(std::abs(lowest), std::abs(highest)) < kMinPercentShown) {
    constexpr double kPpm_per_percent = 1e4;
    chart.y.label = "difference, ppm (band: ± 1 σ)";
    for (ChartCurve& curve : chart.curves)
      for (double& y : curve.y) y *= kPpm_per_percent;
    for (ChartBand& band : chart.bands)
      for (std::vector<double>* edge : {&band.low, &band.high})
        for (double& y : *edge) y *= kPpm_per_percent;
    lowest *= kPpm_per_percent;
    highest *= kPpm_per_percent;
  }
  // The default range covers the curves only; this one shows the whole bands.
  constexpr double kMargin = 0.04;
  const double margin = kMargin * (highest - lowest);
  if (highest > lowest) chart.y.range = {lowest - margin, highest + margin};
  return chart;
}

LineChart chart_of(const std::vector<Comparison>& comparisons) {
  const Comparison& first = comparisons.front();
  return first.deflections.empty() ? compared_frequencies_chart(comparisons) : compared_deflections_chart(first);
}

}  // namespace

CommandReport compare_report(const std::vector<metrics::ComparedDocument>& documents,
                             const metrics::PairOptions& options) {
  assert(documents.size() >= 2);
  std::vector<metrics::ComparedDocument> others;  // with the point numbers of the first document
  std::vector<Comparison> comparisons;
  others.reserve(documents.size());
  comparisons.reserve(documents.size());
  bool deflections = false, modes = false;
  for (std::size_t i = 1; i < documents.size(); ++i) {
    const metrics::ComparedDocument& a = documents.front();
    metrics::CommonPlaces places = metrics::common_places(a, documents[i]);
    const metrics::ComparedDocument& b = others.emplace_back(metrics::at_places_of_first(documents[i], places));
    metrics::PairedModes paired = metrics::pair_modes(a, b, options);
    std::vector<metrics::DistantPair> distant = metrics::distant_pairs(a, b, paired, options);
    comparisons.push_back({.a = a,
                           .b = b,
                           .places = std::move(places),
                           .modes = std::move(paired),
                           .deflections = metrics::pair_deflections(a, b),
                           .distant = std::move(distant)});
    deflections = deflections || !comparisons.back().deflections.empty();
    modes = modes || !comparisons.back().modes.pairs.empty();
  }
  CommandReport report;
  report.json = compare_json(documents, comparisons);
  bool first = true;
  if (modes || !deflections) {
    report.text = compare_modes_text(documents, comparisons);
    first = false;
  }
  for (const Comparison& c : comparisons) {
    if (c.deflections.empty()) continue;
    if (!first) report.text += "\n";
    first = false;
    report.text += compare_deflections_text(c);
  }
  report.columns = columns_of(documents, comparisons);
  report.words = words_of(documents, comparisons);
  report.charts = {chart_of(comparisons)};
  for (const Comparison& c : comparisons) {
    if (auto matrix = mac_matrix_of(c)) report.macs.push_back(std::move(*matrix));
  }
  return report;
}

}  // namespace percuss::report
