#include "report/response_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/error.hpp"
#include "core/io/counted_words.hpp"
#include "core/units.hpp"
#include "report/json/response_json.hpp"
#include "report/svg/response_spectra.hpp"
#include "report/text/analysis_tables.hpp"
#include "report/text/number_format.hpp"
#include "report/text/text_table.hpp"
#include "report/text/version.hpp"
#include "report/text/warnings_text.hpp"

namespace percuss::report {
namespace {

constexpr std::size_t kMaxShapeColumns = 6;
constexpr auto kRight = TextTable::Align::right;

std::string heading(const pipeline::ResponseTest& test) {
  const acquire::Record& record = test.record;
  const std::size_t impacts = pipeline::count_impacts(test);
  const std::string found = impacts == 0 ? "no impact found ·" : fmt::format("{} impact{} ×", impacts, plural(impacts));
  std::string text =
      fmt::format("{}\n  {} · responses only · {} {} channel{}", source_name(record),
                  rounded_frequency_text(record.fs_Hz), found, record.accel.size(), plural(record.accel.size()));
  if (test.fitted && test.possible() && impacts == 0) {
    text += fmt::format(" · band {}–{} Hz", hertz_text(test.band_Hz.first), hertz_text(test.band_Hz.second));
  } else if (test.fitted && test.possible()) {
    text += fmt::format(" · band {}–{} Hz\n  free decay from {:.3g} ms after the impact on, {:.4g} s long",
                        hertz_text(test.band_Hz.first), hertz_text(test.band_Hz.second), 1e3 * test.start_s,
                        static_cast<double>(test.samples) / record.fs_Hz - test.start_s);
  }
  return text + "\n\n";
}

TextTable hits_table(const pipeline::ResponseTest& test) {
  TextTable table({{"hit", kRight}, {"row", kRight}, {"time", kRight}, {"verdict"}});
  for (std::size_t h = 0; h < test.hits.size(); ++h) {
    const pipeline::ResponseHit& hit = test.hits[h];
    std::string verdict = hit.accepted ? "ok" : "rejected";
    if (hit.by_user) verdict += hit.accepted ? " (accepted by the user)" : " (by the user)";
    if (!hit.reason.empty()) verdict += ": " + hit.reason;
    if (!test.fitted && hit.accepted && !hit.impact.whole_pulse)
      verdict += " if the row begins within a decay: no impact rises in it";
    table.add({fmt::format("{}", h + 1), fmt::format("{}", hit.impact.row),
               hit.impact.whole_pulse ? fmt::format("{:.4f} s", hit.onset_s) : "before the row", verdict},
              hit.accepted);
  }
  return table;
}

std::string shape_text(const identify::Residue& residue) {
  const double degrees = std::round(std::arg(residue.value) * kRadian_deg);
  const double shown = degrees <= -180 ? degrees + 360 : degrees == 0 ? 0 : degrees;  // neither −180 nor −0
  return fmt::format("{} ∠ {:.0f}°", value_with_std(std::abs(residue.value), residue.std), shown);
}

TextTable modes_table(const pipeline::ResponseTest& test, bool classes) {
  const bool named = classes && std::any_of(test.classifications.begin(), test.classifications.end(),
                                            [](const auto& one) { return one.ratio.has_value(); });
  const std::size_t channels = test.record.accel.size();
  const std::size_t shown = channels > kMaxShapeColumns ? 0 : channels;
  std::vector<TextTable::Column> columns{{"mode", kRight}};
  if (named) columns.insert(columns.end(), {{"family"}, {"confidence", kRight}});
  columns.push_back({"frequency", kRight});
  columns.push_back({"damping", kRight});
  for (std::size_t c = 0; c < shown; ++c) {
    if (c != test.found.reference)
      columns.push_back({channel_label(test, c) + " / " + channel_label(test, test.found.reference), kRight});
  }
  columns.push_back({"note"});
  TextTable table(columns);
  for (std::size_t m = 0; m < test.found.modes.size(); ++m) {
    const identify::Mode& mode = test.found.modes[m].mode;
    std::vector<std::string> cells{fmt::format("{}", m + 1)};
    if (named) {
      cells.push_back(mode_type_of(test.classifications[m]));
      cells.push_back(confidence_text(test.classifications[m]));
    }
    cells.push_back(value_with_std(mode.pole.freq_Hz, mode.freq_std_Hz) + " Hz");
    cells.push_back(value_with_std(100 * mode.pole.damping_ratio, 100 * mode.damping_std) + " %");
    for (std::size_t c = 0; c < shown; ++c) {
      if (c != test.found.reference) cells.push_back(shape_text(mode.residues[c]));
    }
    cells.push_back(source_of_std(mode));
    table.add(std::move(cells));
  }
  return table;
}

ReportText text_of(const pipeline::ResponseTest& test, const std::set<ReportSection>& sections) {
  const bool classes = sections.contains(ReportSection::classes);
  const bool modes = classes || sections.contains(ReportSection::modes);
  ReportText text = heading(test);
  // Beside the modes of a single usable hit, a table of hits says nothing.
  const bool hits = sections.contains(ReportSection::hits) && !test.hits.empty() && !test.no_impact &&
                    (test.hits.size() > 1 || !test.possible() || !modes);
  if (hits) {
    text += hits_table(test);
    text += std::string("\n");
  }
  if (modes && test.possible() && test.found.modes.empty())
    text += std::string("no mode rises above the noise in the band\n");
  if (modes && !test.found.modes.empty()) text += modes_table(test, classes);
  if (modes && test.possible()) text += std::string("\n");
  text += warnings_text(test.warnings);
  return text;
}

// A row per mode. With several tests, the first column is the number of the test, and a test with fewer channels than
// others leaves fields empty.
std::vector<NumericColumn> columns_of(const std::vector<pipeline::ResponseTest>& tests) {
  std::vector<NumericColumn> out;
  if (tests.size() > 1) out.push_back({"test", {}});
  for (const char* name : {"mode", "frequency_hz", "frequency_std_hz", "damping_ratio", "damping_ratio_std"})
    out.push_back({name, {}});
  std::size_t channels = 0;
  for (const pipeline::ResponseTest& test : tests) channels = std::max(channels, test.record.accel.size());
  for (std::size_t c = 0; c < channels; ++c) {
    for (const char* part : {"re", "im", "std"}) out.push_back({fmt::format("channel_{}_{}", c, part), {}});
  }
  for (std::size_t t = 0; t < tests.size(); ++t) {
    for (std::size_t m = 0; m < tests[t].found.modes.size(); ++m) {
      const identify::Mode& mode = tests[t].found.modes[m].mode;
      std::vector<double> row;
      if (tests.size() > 1) row.push_back(static_cast<double>(t));
      row.insert(row.end(), {static_cast<double>(m), mode.pole.freq_Hz, mode.freq_std_Hz, mode.pole.damping_ratio,
                             mode.damping_std});
      for (const identify::Residue& r : mode.residues) row.insert(row.end(), {r.value.real(), r.value.imag(), r.std});
      row.resize(out.size(), std::numeric_limits<double>::quiet_NaN());
      for (std::size_t i = 0; i < row.size(); ++i) out[i].values.push_back(row[i]);
    }
  }
  return out;
}

// The file of each row of columns_of().
WordColumn files_of_rows(const std::vector<pipeline::ResponseTest>& tests) {
  WordColumn out{.name = "file", .values = {}};
  for (const pipeline::ResponseTest& test : tests)
    out.values.insert(out.values.end(), test.found.modes.size(), source_name(test.record));
  return out;
}

}  // namespace

CommandReport response_report(const std::vector<pipeline::ResponseTest>& tests, const ResponseReportOptions& options) {
  CommandReport report;
  report.json = responses_json(tests, options.bat, options.sections);
  for (std::size_t t = 0; t < tests.size(); ++t) {
    if (tests.size() > 1) report.text += fmt::format("{}test {}\n", t == 0 ? "" : "\n", t);
    report.text += text_of(tests[t], options.sections);
  }
  report.columns = columns_of(tests);
  if (tests.size() > 1) report.words = {files_of_rows(tests)};
  for (std::size_t t = 0; t < tests.size() && options.charts; ++t) {
    for (LineChart& chart : response_spectra(tests[t])) {
      if (tests.size() > 1) chart.title = fmt::format("test {}: {}", t, chart.title);
      report.charts.push_back(std::move(chart));
    }
  }
  return report;
}

}  // namespace percuss::report
