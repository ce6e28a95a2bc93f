#pragma once
#include <nlohmann/json_fwd.hpp>

#include "pipeline/analysis_options.hpp"

namespace percuss::report {

/// The options of an analysis that differ from their defaults, except band and effort, which are members of their own.
nlohmann::ordered_json options_json(const pipeline::AnalysisOptions& options);

}  // namespace percuss::report
