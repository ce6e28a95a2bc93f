// percuss_stress [--full] [--only TEXT] [--table FILE.md] [--record RUN FILE]
// Runs the cells of the stress tables. A cell is one synthetic test with its expected outcome, repeated with other
// noise and hits.
//   --full     run every cell more often
//   --only     run the cell of this "group: name", or all cells whose names contain the text
//   --table    replace the text after the line <!-- measured --> of FILE.md
//   --record   write the record of run RUN of the chosen cell and exit
// Exit code 1: a cell fails without a known defect, or the coverage of the intervals is wrong. Exit code 2: the command
// line is wrong, or a file cannot be written.
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "acquire/write_record.hpp"
#include "cell.hpp"
#include "summary.hpp"

namespace percuss::stress {
namespace {

// Of 95 % intervals. Intervals that are 16 % too narrow cover 90 %, intervals that are 19 % too wide cover 98 %.
constexpr double kMinCoverage = 0.90, kMaxCoverage = 0.98;
constexpr std::size_t kMinModes = 300;  // a coverage of 95 % is then known to ± 1.3 %
constexpr const char* kMeasured = "<!-- measured -->\n";

struct Options {
  bool full = false;
  std::string only, table, record;
  std::size_t record_run = 0;
};

Options parse(const std::vector<std::string>& words) {
  Options options;
  const auto value = [&](std::size_t& i) {
    if (++i == words.size()) throw std::invalid_argument(words.back() + ": a value is missing");
    return words[i];
  };
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--full") {
      options.full = true;
    } else if (words[i] == "--only") {
      options.only = value(i);
    } else if (words[i] == "--table") {
      options.table = value(i);
    } else if (words[i] == "--record") {
      options.record_run = std::stoul(value(i));
      options.record = value(i);
    } else {
      throw std::invalid_argument(words[i] + ": no such option");
    }
  }
  return options;
}

std::vector<Check> all_checks() {
  std::vector<Check> checks;
  for (auto* const cells :
       {spacing_cells, damping_cells, noise_cells, recorder_cells, scale_cells, length_cells, structure_cells}) {
    for (Cell& cell : cells()) checks.push_back(check_of(std::move(cell)));
  }
  for (Check& check : invariance_checks()) checks.push_back(std::move(check));
  return checks;
}

void write_table(const std::string& path, const std::string& tables) {
  std::ifstream in(path);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::size_t at = text.find(kMeasured);
  if (at == std::string::npos) throw std::invalid_argument(path + ": no line <!-- measured -->");
  text.resize(at + std::string(kMeasured).size());
  std::ofstream out(path);
  out << text << tables;
  out.close();
  if (!out) throw std::runtime_error(path + ": cannot be written");
}

std::string text_of(const Coverage& coverage) {
  if (coverage.modes == 0) return "no intervals to compare with the truth";
  return fmt::format("95 % intervals hold the truth in {:.1f} % (frequency) and {:.1f} % (damping ratio) of {} modes",
                     100 * coverage.of_freq(), 100 * coverage.of_damping(), coverage.modes);
}

bool in_range(double fraction) { return fraction >= kMinCoverage && fraction <= kMaxCoverage; }

int run(const Options& options) {
  std::vector<Check> checks = all_checks();
  const auto full_name = [](const Check& check) { return check.group + ": " + check.name; };
  // A full name selects only its cell, even if it is a part of other names.
  const bool exact =
      std::any_of(checks.begin(), checks.end(), [&](const Check& c) { return full_name(c) == options.only; });
  std::erase_if(checks, [&](const Check& check) {
    return exact ? full_name(check) != options.only : full_name(check).find(options.only) == std::string::npos;
  });
  if (!options.record.empty()) {
    if (checks.size() != 1)
      throw std::invalid_argument(fmt::format("--record needs one cell, --only selects {}", checks.size()));
    if (!checks.front().record) throw std::invalid_argument("--record: this check has no record");
    acquire::write_record(options.record, checks.front().record(options.record_run), true);
    return 0;
  }
  const auto summaries = run_all(checks, options.full);
  std::size_t failed = 0, known = 0;
  Coverage coverage;
  for (const Summary& summary : summaries) {
    std::cout << lines_of(summary);
    add(coverage, summary.coverage);
    if (summary.failed()) ++(summary.known() ? known : failed);
    if (!summary.failed() && summary.known() && options.full)
      std::cout << "      no longer fails; remove its defect from the cell\n";
  }
  const std::string cells = fmt::format("{} cells: {} as expected, {} with known defects, {} fail.", summaries.size(),
                                        summaries.size() - known - failed, known, failed);
  std::cout << cells << ' ' << text_of(coverage) << '\n';
  if (!options.table.empty()) {
    const std::string defects = defects_of(summaries);
    write_table(options.table, "\n" + cells + '\n' + text_of(coverage) + ".\n" +
                                   (defects.empty() ? "" : "\n### Known defects\n" + defects) + tables_of(summaries));
  }
  const bool covered = coverage.modes < kMinModes || (in_range(coverage.of_freq()) && in_range(coverage.of_damping()));
  return failed == 0 && covered ? 0 : 1;
}

}  // namespace
}  // namespace percuss::stress

int main(int argc, char** argv) {
  try {
    return percuss::stress::run(percuss::stress::parse({argv + 1, argv + argc}));
  } catch (const std::exception& e) {
    std::cerr << "percuss_stress: " << e.what() << '\n';
    return 2;
  }
}
