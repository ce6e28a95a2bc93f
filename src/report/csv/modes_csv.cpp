#include "report/csv/modes_csv.hpp"

#include <fmt/format.h>

#include <iterator>

#include "identify/shapes/mode_shapes.hpp"

namespace percuss::report {
namespace {

std::string header_of(bool several_tests) {
  return std::string(several_tests ? "test," : "") +
         "mode,frequency_hz,frequency_std_hz,damping_ratio,damping_ratio_std,family,order,point,channel,residue_re,"
         "residue_im,residue_std\n";
}

// Adds a line per residue; `test` begins each.
void add_mode(std::string& out, const std::string& test, std::size_t number, const identify::Mode& mode,
              const identify::ModeClassification& found) {
  auto end = std::back_inserter(out);
  for (const identify::Residue& residue : mode.residues) {
    fmt::format_to(end, "{}{},{},{},{},{},{},{},{},{},{},{},{}\n", test, number, mode.pole.freq_Hz, mode.freq_std_Hz,
                   mode.pole.damping_ratio, mode.damping_std, name_of(found.type),
                   found.order > 0 ? fmt::format("{}", found.order) : "", residue.point, residue.channel,
                   residue.value.real(), residue.value.imag(), identify::total_std(residue));
  }
}

}  // namespace

std::string modes_csv(const std::vector<NumberedAnalysis>& tests) {
  std::string out = header_of(tests.size() > 1);
  for (const NumberedAnalysis& test : tests) {
    if (!test.analysis->possible()) continue;
    const auto& modes = test.analysis->modes();
    const std::string test_cell = tests.size() > 1 ? fmt::format("{},", test.run) : "";
    for (std::size_t m = 0; m < modes.size(); ++m)
      add_mode(out, test_cell, m, modes[m], test.analysis->classifications()[m]);
  }
  return out;
}

std::string modes_csv(const std::vector<pipeline::ResponseTest>& tests) {
  std::string out = header_of(tests.size() > 1);
  for (std::size_t t = 0; t < tests.size(); ++t) {
    const std::string test_cell = tests.size() > 1 ? fmt::format("{},", t) : "";
    const auto& modes = tests[t].found.modes;
    for (std::size_t m = 0; m < modes.size(); ++m)
      add_mode(out, test_cell, m, modes[m].mode, tests[t].classifications[m]);
  }
  return out;
}

}  // namespace percuss::report
