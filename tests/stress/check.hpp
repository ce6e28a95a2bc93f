#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::stress {

/// How far a mode came out from the truth, in its own reported deviations.
struct Miss {
  double freq_sigmas = 0;
  double damping_sigmas = 0;
};

/// What one run of a check found out.
struct Result {
  std::vector<std::string> failures;  // none: as expected
  std::set<std::string> said;         // codes of findings and warnings, "exit 3", "exit 4"
  std::size_t wanted = 0, found = 0;  // modes that must be found one by one, and those of the truth that were
  double freq_relative = 0;           // the largest error over the modes found, relative
  double damping_absolute = 0;        // … of the damping ratio
  double freq_bound = 0;              // the largest bound on a frequency over half its mode's bandwidth; 0: none
  std::vector<Miss> misses;           // of the modes found
  bool calibrated = false;            // the noise is as the deviations assume, so that intervals must cover
};

/// One cell of the grid.
struct Check {
  std::string group, name;
  std::string expectation;  // in words, for the table
  std::string defect;       // a known defect by which it fails, in words; it must then fail
  std::size_t runs = 1;     // with other noise, in the short suite …
  std::size_t full_runs = 1;
  std::function<Result(std::uint64_t run)> run;
  std::function<acquire::Record(std::uint64_t run)>
      record{};  // what is analysed, to be written to a file; may be empty
};

}  // namespace percuss::stress
