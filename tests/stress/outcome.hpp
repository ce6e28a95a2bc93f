#pragma once
#include <set>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"
#include "identify/model/mode.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::stress {

/// What an analysis says of a record, as the tool would end: with modes, or with an exit code and a reason.
struct CommandResult {
  int exit_code = 0;
  std::string message;         // of an error
  std::set<std::string> said;  // codes of warnings and of the hits' findings
  std::vector<identify::Mode> modes;
  std::vector<double> unclaimed_Hz;  // the peaks that the warning of that name names
  double df_Hz = 0;                  // between lines
};

CommandResult analyse(acquire::Record record, const pipeline::AnalysisOptions& options);

/// "frequency of mode 2" where a number of a mode is no number or its deviation none; empty when all are.
std::string unusable_number(const std::vector<identify::Mode>& modes);

}  // namespace percuss::stress
