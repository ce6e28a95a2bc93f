#pragma once
#include <nlohmann/json_fwd.hpp>

#include "identify/model/mode.hpp"

namespace percuss::report {

/// Adds the parts of a mode's standard deviations, and its trends over the hits, to the mode's object.
void add_std_parts(nlohmann::ordered_json& json, const identify::Mode& mode);

}  // namespace percuss::report
