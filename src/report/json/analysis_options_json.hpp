#pragma once
#include <nlohmann/json_fwd.hpp>

#include "pipeline/analysis_options.hpp"

namespace percuss::report {

/// The user's options that act on the results, where they differ from their defaults. Without band and effort, which
/// are members of their own.
nlohmann::ordered_json options_json(const pipeline::AnalysisOptions& options);

}  // namespace percuss::report
