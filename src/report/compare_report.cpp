#include "report/compare_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "report/json/compare_json.hpp"
#include "report/text/number_format.hpp"
#include "report/text/text_table.hpp"

namespace percuss::report {
namespace {

constexpr std::size_t kMaxNamed = 8;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

const metrics::ModePair* pair_at(const Comparison& c, std::size_t mode) {
  for (const metrics::ModePair& pair : c.modes.pairs) {
    if (pair.a == mode) return &pair;
  }
  return nullptr;
}

// Without a sign where the value rounds to zero.
std::string signed_percent(double percent) {
  std::string text = fmt::format("{:+.2f}", percent);
  return text == "-0.00" || text == "+0.00" ? "0.00" : text;
}

// "-0.25 %, 154 σ": the difference, and how many of its standard deviations it is, where both values have one.
std::string difference_text(double percent, const std::optional<double>& std_percent, bool both_have_std) {
  constexpr double kLargest = 1000;
  std::string text = signed_percent(percent) + " %";
  if (!both_have_std || !std_percent || !(*std_percent > 0)) return text;
  const double deviations = std::abs(percent) / *std_percent;
  if (deviations >= kLargest) return text + fmt::format(", over {:.0f} σ", kLargest);
  return text + (deviations < 10 ? fmt::format(", {:.1f} σ", deviations) : fmt::format(", {:.0f} σ", deviations));
}

std::string frequency_text(const metrics::ComparedMode& mode) {
  return value_with_std(mode.freq_Hz, mode.freq_std_Hz) + " Hz";
}

std::string damping_text(const metrics::ComparedMode& mode) {
  return mode.damping_ratio ? value_with_std(100 * *mode.damping_ratio, 100 * mode.damping_std) + " %" : "–";
}

// Modes of beams are numbered from 0, as in the tables of the models; all others from 1.
std::size_t first_number(const metrics::ComparedDocument& document) {
  return document.schema == "percuss/model-beam/1" ? 0 : 1;
}

// Whether a mode of the document has a type. Modes of a plate or a beam have none.
bool names_families(const metrics::ComparedDocument& document) {
  return std::any_of(document.modes.begin(), document.modes.end(), [](const metrics::ComparedMode& mode) {
    return !mode.family.empty() && mode.family != "unknown";
  });
}

// The first cells of a mode's row.
std::vector<std::string> mode_cells(const metrics::ComparedDocument& document, std::size_t m) {
  std::vector<std::string> cells{std::to_string(first_number(document) + m)};
  if (names_families(document)) cells.push_back(document.modes[m].family);
  return cells;
}

TextTable modes_table(const std::vector<metrics::ComparedDocument>& documents) {
  std::vector<TextTable::Column> heads{{"mode", TextTable::Align::right}};
  if (names_families(documents.front())) heads.push_back({"family"});
  for (const metrics::ComparedDocument& document : documents)
    heads.push_back({one_line(document.name, 40), TextTable::Align::right});
  heads.push_back({""});
  return TextTable(std::move(heads));
}

// The dampings of the paired modes, where two documents state them.
std::optional<TextTable> dampings_table(const std::vector<metrics::ComparedDocument>& documents,
                                        const std::vector<Comparison>& comparisons) {
  TextTable table = modes_table(documents);
  bool any = false;
  for (std::size_t m = 0; m < documents.front().modes.size(); ++m) {
    const metrics::ComparedMode& mode = documents.front().modes[m];
    std::vector<std::string> cells = mode_cells(documents.front(), m);
    cells.push_back(damping_text(mode));
    bool paired = false;
    for (const Comparison& c : comparisons) {
      const metrics::ModePair* pair = pair_at(c, m);
      const bool differs = pair && pair->damping_difference_percent;
      paired = paired || differs;
      cells.push_back(
          !pair ? "–"
          : differs
              ? fmt::format("{} ({})", damping_text(c.b.modes[pair->b]),
                            difference_text(*pair->damping_difference_percent, pair->damping_difference_std_percent,
                                            mode.damping_std > 0 && c.b.modes[pair->b].damping_std > 0))
              : damping_text(c.b.modes[pair->b]));
    }
    cells.emplace_back("");
    if (paired) table.add(std::move(cells));
    any = any || paired;
  }
  return any ? std::optional(std::move(table)) : std::nullopt;
}

ReportText modes_text(const std::vector<metrics::ComparedDocument>& documents,
                      const std::vector<Comparison>& comparisons) {
  TextTable table = modes_table(documents);
  for (std::size_t m = 0; m < documents.front().modes.size(); ++m) {
    const metrics::ComparedMode& mode = documents.front().modes[m];
    if (!(mode.freq_Hz > 0)) continue;
    std::vector<std::string> cells = mode_cells(documents.front(), m);
    cells.push_back(frequency_text(mode));
    for (const Comparison& c : comparisons) {
      const metrics::ModePair* pair = pair_at(c, m);
      std::string cell = pair ? fmt::format("{} ({}", frequency_text(c.b.modes[pair->b]),
                                            difference_text(pair->difference_percent, pair->difference_std_percent,
                                                            mode.freq_std_Hz > 0 && c.b.modes[pair->b].freq_std_Hz > 0))
                              : "–";
      if (pair) cell += pair->mac ? fmt::format(", MAC {:.3f})", pair->mac->value) : ")";
      cells.push_back(std::move(cell));
    }
    cells.emplace_back("");
    table.add(std::move(cells));
  }
  ReportText text;
  text += table;
  for (const Comparison& c : comparisons) {
    if (c.modes.unpaired_b.empty()) continue;
    std::string only = fmt::format("only in {}:", one_line(c.b.name, 200));
    const auto& unpaired = c.modes.unpaired_b;
    const std::size_t shown = std::min(unpaired.size(), kMaxNamed);
    for (std::size_t i = 0; i < shown; ++i) only += fmt::format(" {:.6g} Hz", c.b.modes[unpaired[i]].freq_Hz);
    if (shown < unpaired.size()) only += fmt::format(" and {} more", unpaired.size() - shown);
    text.say(only);
  }
  if (auto dampings = dampings_table(documents, comparisons)) {
    text += "\ndamping\n";
    text += *dampings;
  }
  return text;
}

ReportText deflections_text(const Comparison& c) {
  const bool inverted = c.a.model && !c.b.model;
  TextTable table({{"position", TextTable::Align::right},
                   {one_line(c.a.name, 40), TextTable::Align::right},
                   {one_line(c.b.name, 40), TextTable::Align::right},
                   {inverted ? "first/second" : "second/first", TextTable::Align::right},
                   {""}});
  for (const metrics::DeflectionPair& pair : c.deflections) {
    const std::string place = pair.position_m ? fmt::format("{:.1f} mm", 1000 * *pair.position_m)
                              : pair.point    ? fmt::format("point {}", *pair.point)
                                              : "";
    table.add({place, fmt::format("{:.4g} mm", 1000 * pair.a_m), fmt::format("{:.4g} mm", 1000 * pair.b_m),
               value_with_std(pair.ratio, pair.ratio_std), ""});
  }
  ReportText text(std::string("largest deflection\n"));
  text += table;
  return text;
}

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
      of_first("mode", [&](std::size_t m) { return static_cast<double>(first_number(first) + m); }),
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

LineChart chart_of(const std::vector<Comparison>& comparisons) {
  const Comparison& first = comparisons.front();
  LineChart chart;
  if (!first.deflections.empty()) {
    // One scale for all: places in a document may have a position, or a point, or both.
    const auto all_have = [&](auto member) {
      return std::all_of(first.deflections.begin(), first.deflections.end(),
                         [&](const metrics::DeflectionPair& pair) { return (pair.*member).has_value(); });
    };
    const bool positions = all_have(&metrics::DeflectionPair::position_m);
    const bool points = all_have(&metrics::DeflectionPair::point);
    chart = {.title = "Largest deflection",
             .x = {.label = positions ? "position, m"
                            : points  ? "point"
                                      : "place in the table"},
             .y = {.label = "largest deflection, mm"}};
    ChartCurve a{.name = first.a.name, .marks = true}, b{.name = first.b.name, .marks = true};
    for (const metrics::DeflectionPair& pair : first.deflections) {
      const double place = positions ? *pair.position_m : points ? *pair.point : 1 + static_cast<double>(a.x.size());
      for (ChartCurve* curve : {&a, &b}) curve->x.push_back(place);
      a.y.push_back(1000 * pair.a_m);
      b.y.push_back(1000 * pair.b_m);
    }
    chart.curves = {a, b};
    return chart;
  }
  chart = {.title = "Frequencies against " + first.a.name,
           .x = {.label = "frequency, Hz"},
           .y = {.label = "difference, % (band: ± 1 σ)"}};
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
  // The default range covers the curves only; this one shows the whole bands.
  constexpr double kMargin = 0.04;
  const double margin = kMargin * (highest - lowest);
  if (highest > lowest) chart.y.range = {lowest - margin, highest + margin};
  return chart;
}

}  // namespace

CommandReport compare_report(const std::vector<metrics::ComparedDocument>& documents,
                             const metrics::PairOptions& options) {
  assert(documents.size() >= 2);
  std::vector<Comparison> comparisons;
  comparisons.reserve(documents.size());
  bool deflections = false, modes = false;
  for (std::size_t i = 1; i < documents.size(); ++i) {
    const metrics::ComparedDocument &a = documents.front(), &b = documents[i];
    comparisons.push_back(
        {.a = a, .b = b, .modes = metrics::pair_modes(a, b, options), .deflections = metrics::pair_deflections(a, b)});
    deflections = deflections || !comparisons.back().deflections.empty();
    modes = modes || !comparisons.back().modes.pairs.empty();
  }
  CommandReport report;
  report.json = compare_json(documents, comparisons);
  bool first = true;
  if (modes || !deflections) {
    report.text = modes_text(documents, comparisons);
    first = false;
  }
  for (const Comparison& c : comparisons) {
    if (c.deflections.empty()) continue;
    if (!first) report.text += "\n";
    first = false;
    report.text += deflections_text(c);
  }
  report.columns = columns_of(documents, comparisons);
  report.charts = {chart_of(comparisons)};
  for (const Comparison& c : comparisons) {
    if (auto matrix = mac_matrix_of(c)) report.macs.push_back(std::move(*matrix));
  }
  return report;
}

}  // namespace percuss::report
