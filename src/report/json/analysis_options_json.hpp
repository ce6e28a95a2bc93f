#pragma once
#include <nlohmann/json_fwd.hpp>

#include "pipeline/analysis_options.hpp"
#include "report/json/analysis_json.hpp"

namespace percuss::report {

/// The options of an analysis that differ from their defaults.
nlohmann::ordered_json options_json(const pipeline::AnalysisOptions& options);

/// A bat's id and properties.
nlohmann::ordered_json bat_json(const BatLabel& bat);

}  // namespace percuss::report
