#pragma once
#include <set>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"
#include "identify/model/mode.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::stress {

/// The outcome of an analysis as the tool would report it: modes, or an exit code and a reason.
struct CommandResult {
  int exit_code = 0;
  std::string message;         // of an error
  std::set<std::string> said;  // codes of warnings and of findings
  std::vector<identify::Mode> modes;
  std::vector<double> unexplained_Hz;  // peaks named by the warning unclaimed_peaks
  double df_Hz = 0;                    // line spacing
};

CommandResult analyse(acquire::Record record, const pipeline::AnalysisOptions& options);

/// "frequency of mode 2 is not usable" for a number that is not finite or out of range, or a missing standard
/// deviation; empty if all numbers are usable.
std::string unusable_number(const std::vector<identify::Mode>& modes);

}  // namespace percuss::stress
