#pragma once
#include <nlohmann/json_fwd.hpp>

#include "pipeline/analysis_options.hpp"

namespace percuss::report {

/// The options of an analysis that differ from their defaults.
nlohmann::ordered_json options_json(const pipeline::AnalysisOptions& options);

}  // namespace percuss::report
