#pragma once
#include <vector>

#include "model/impact/impact.hpp"
#include "report/html/command_report.hpp"
#include "report/impact_sweep_report.hpp"
#include "report/structure_report.hpp"

namespace percuss::report {

/// JSON: percuss/model-impact/1. Columns and charts show the time series or, if there are any, the sweeps. Where the
/// swept impacts hold their motion over time, the columns are that motion, and a chart shows it, too. `nonuniform` is
/// the beam with a table of sections, if it has one.
CommandReport impact_report(const model::Impact& impact, const model::ImpactResult& result,
                            const std::vector<ImpactSweep>& sweeps = {},
                            const model::BeamStructure* nonuniform = nullptr, const StructureOrigin& origin = {});

}  // namespace percuss::report
