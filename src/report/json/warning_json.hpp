#pragma once
#include <nlohmann/json_fwd.hpp>

#include "pipeline/warnings/warning.hpp"

namespace percuss::report {

/// A warning with its severity and, where it has one, its remedy.
nlohmann::ordered_json warning_json(const pipeline::Warning& warning);

}  // namespace percuss::report
