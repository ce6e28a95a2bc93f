#pragma once
#include <optional>
#include <vector>

#include "commands/analyze_tests.hpp"
#include "report/json/analysis_json.hpp"

namespace percuss::tools {

/// Analyses records without a force: modes from free decays. Returns the exit code.
/// errors  OptionError: an option that needs a force; InputError: an output file of FRFs.
int analyze_responses(const AnalyzeFlags& flags, std::vector<acquire::Record> records,
                      const std::optional<report::BatLabel>& bat);

}  // namespace percuss::tools
