#pragma once
#include <string>
#include <vector>

#include "model/impact/impact.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// One parameter varied, the others as in the impact reported.
struct ImpactSweep {
  std::string parameter;  // "ei", "torsion", "rho_a", "at", "speed"
  std::vector<double> values;
  std::vector<model::ImpactResult> results;  // [values]
};

/// percuss/model-impact/1. Columns and chart show the series, or the sweeps where there are any.
CommandReport impact_report(const model::Impact& impact, const model::ImpactResult& result,
                            const std::vector<ImpactSweep>& sweeps = {});

/// What a sweep varies: nullptr for a name that is none.
double* swept_value(model::Impact& impact, const std::string& parameter);

}  // namespace percuss::report
