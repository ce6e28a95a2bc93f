#pragma once
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "check.hpp"

namespace percuss::stress {

/// The number of modes, and how many intervals of ±1.96 reported standard deviations contain the true frequency and the
/// true damping ratio.
struct Coverage {
  std::size_t modes = 0, freq = 0, damping = 0;
  double of_freq() const { return static_cast<double>(freq) / static_cast<double>(modes); }
  double of_damping() const { return static_cast<double>(damping) / static_cast<double>(modes); }
};
void add(Coverage& to, const Coverage& more);

/// The results of all runs of a check.
struct Summary {
  Check check;
  std::size_t runs = 0, failed_runs = 0;
  std::vector<std::pair<std::size_t, std::string>> failures;  // run and failure
  std::set<std::string> said;  // codes of findings and warnings, and exit codes, of all runs
  std::size_t wanted = 0, found = 0;
  double freq_relative = 0, damping_absolute = 0, freq_bound = 0;  // the largest of all runs, as in Result
  ModeError largest;
  Coverage coverage;

  bool failed() const { return failed_runs > 0; }
  bool known() const { return !check.defect.empty(); }
};

/// Runs all checks in parallel.
std::vector<Summary> run_all(const std::vector<Check>& checks, bool full);

/// "ok", "FAILS" or "known", group and name of the check, the measurements and the failures.
std::string lines_of(const Summary& summary);
/// A Markdown list of the known defects with their checks.
std::string defects_of(const std::vector<Summary>& summaries);
/// Markdown tables of all checks, one per group.
std::string tables_of(const std::vector<Summary>& summaries);

}  // namespace percuss::stress
