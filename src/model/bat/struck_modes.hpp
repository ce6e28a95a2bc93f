#pragma once
#include <cstddef>
#include <vector>

#include "model/bat/bat_modes.hpp"
#include "model/impact/impact.hpp"

namespace percuss::model {

/// The lowest `modes` modes at at_m, rigid-body modes first, for an impact on a beam with a table of sections.
std::vector<StruckMode> struck_modes(const BatModes& beam, double at_m, std::size_t modes);

}  // namespace percuss::model
