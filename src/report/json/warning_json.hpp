#pragma once
#include <nlohmann/json_fwd.hpp>

#include "core/warning.hpp"

namespace percuss::report {

/// A warning with its severity and, where it has one, its remedy. Without a severity, the ranking of the analysis's
/// warnings decides.
nlohmann::ordered_json warning_json(const warnings::Warning& warning);

}  // namespace percuss::report
