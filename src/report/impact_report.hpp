#pragma once
#include <string>
#include <vector>

#include "model/impact/impact.hpp"
#include "report/html/command_report.hpp"
#include "report/structure_report.hpp"

namespace percuss::report {

/// A sweep: one parameter varies, the others have the values of the reported impact.
struct ImpactSweep {
  std::string parameter;  // "ei", "torsion", "rho_a", "at", "speed"
  std::vector<double> values;
  std::vector<model::ImpactResult> results;  // [values]
};

/// JSON: percuss/model-impact/1. Columns and charts show the time series or, if there are any, the sweeps. `shaped` is
/// the beam with a table of sections, if it has one.
CommandReport impact_report(const model::Impact& impact, const model::ImpactResult& result,
                            const std::vector<ImpactSweep>& sweeps = {}, const model::BeamStructure* shaped = nullptr,
                            const StructureOrigin& origin = {});

/// The value of `impact` that a sweep of `parameter` varies; nullptr for an unknown name.
double* swept_value(model::Impact& impact, const std::string& parameter);

}  // namespace percuss::report
