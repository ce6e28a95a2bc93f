#pragma once
#include <cstddef>

#include "model/bat/bat_modes.hpp"
#include "report/html/command_report.hpp"
#include "report/structure_report.hpp"

namespace percuss::report {

/// JSON: percuss/model-beam/1, of a beam with a table of sections: no λ, and no EI and ρA of the whole. The lowest
/// `modes` modes, rigid-body modes first; shapes as columns and chart, 1 at the free end.
CommandReport nonuniform_beam_report(const model::BeamStructure& beam, const model::BatModes& elastic,
                                     std::size_t modes, const StructureOrigin& origin);

}  // namespace percuss::report
