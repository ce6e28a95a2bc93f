#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::stress {

/// The error of a mode in its reported standard deviations.
struct ModeError {
  double freq_sigmas = 0;
  double damping_sigmas = 0;
};

/// The result of one run of a check.
struct Result {
  std::vector<std::string> failures;   // none: as expected
  std::set<std::string> said;          // codes of findings and warnings; "exit N" if the exit code N is not 0
  std::size_t wanted = 0, found = 0;   // true modes that must be found, and true modes found
  double freq_relative = 0;            // largest relative error of a frequency, over the modes found
  double damping_absolute = 0;         // largest absolute error of a damping ratio
  double freq_bound = 0;               // largest Cramér–Rao bound of a frequency, over half its bandwidth; 0: none
  std::vector<ModeError> mode_errors;  // of the found modes
  /// The noise meets the assumptions of the standard deviations, so the confidence intervals must cover the truth.
  bool calibrated = false;
};

/// One test of the stress suite in the form that it runs: made from a Cell (cell.hpp), or an invariance check.
struct Check {
  std::string group, name;
  std::string expectation;  // as text, for the table
  std::string defect;       // a known defect as text; the check may then fail
  std::size_t runs = 1;     // with different noise, in the short suite
  std::size_t full_runs = 1;
  std::function<Result(std::uint64_t run)> run;
  std::function<acquire::Record(std::uint64_t run)>
      record{};  // for writing the analysed record to a file; may be empty
};

}  // namespace percuss::stress
