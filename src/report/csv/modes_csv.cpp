#include "report/csv/modes_csv.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "core/io/csv_cell.hpp"
#include "identify/shapes/mode_shapes.hpp"
#include "report/text/analysis_tables.hpp"

namespace percuss::report {
namespace {

std::string header_of(bool several_tests) {
  return std::string(several_tests ? "test," : "") +
         "mode,frequency_hz,frequency_std_hz,damping_ratio,damping_ratio_std,family,order,point,channel,residue_re,"
         "residue_im,residue_std" +
         (several_tests ? ",file\n" : "\n");
}

// The first and the last cell of the lines of a test, separators included; empty for a single test.
struct LineEnds {
  std::string test, file;
};

LineEnds line_ends(std::size_t tests, std::string number, const acquire::Record& record) {
  if (tests == 1) return {};
  return {.test = std::move(number) + ",", .file = "," + csv_cell(source_name(record))};
}

// Adds a line per residue.
void add_mode(std::string& out, const LineEnds& ends, std::size_t number, const identify::Mode& mode,
              const identify::ModeClassification& found) {
  auto end = std::back_inserter(out);
  for (const identify::Residue& residue : mode.residues) {
    fmt::format_to(end, "{}{},{},{},{},{},{},{},{},{},{},{},{}{}\n", ends.test, number, mode.pole.freq_Hz,
                   mode.freq_std_Hz, mode.pole.damping_ratio, mode.damping_std, name_of(found.type),
                   found.order > 0 ? fmt::format("{}", found.order) : "", residue.point, residue.channel,
                   residue.value.real(), residue.value.imag(), identify::total_std(residue), ends.file);
  }
}

}  // namespace

std::string modes_csv(const std::vector<NumberedAnalysis>& tests) {
  std::string out = header_of(tests.size() > 1);
  for (const NumberedAnalysis& test : tests) {
    if (!test.analysis->possible()) continue;
    const auto& modes = test.analysis->modes();
    const LineEnds ends = line_ends(tests.size(), fmt::format("{}", test.run), test.analysis->record());
    for (std::size_t m = 0; m < modes.size(); ++m)
      add_mode(out, ends, m, modes[m], test.analysis->classifications()[m]);
  }
  return out;
}

std::string modes_csv(const std::vector<pipeline::ResponseTest>& tests) {
  std::string out = header_of(tests.size() > 1);
  for (std::size_t t = 0; t < tests.size(); ++t) {
    const LineEnds ends = line_ends(tests.size(), fmt::format("{}", t), tests[t].record);
    const auto& modes = tests[t].found.modes;
    for (std::size_t m = 0; m < modes.size(); ++m) add_mode(out, ends, m, modes[m].mode, tests[t].classifications[m]);
  }
  return out;
}

}  // namespace percuss::report
