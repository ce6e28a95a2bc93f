#pragma once
#include <optional>
#include <vector>

#include "model/beam/beam.hpp"
#include "model/beam/beam_fit.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// Measurements that the beam's values were fitted to.
struct BeamOrigin {
  std::optional<model::BeamFit> fit;
  std::vector<model::MeasuredFrequency> measured;  // that the fit used
  std::optional<model::TorsionFit> torsion;        // from static readings
};

/// JSON: percuss/model-beam/1. Frequencies, nodes, shapes (as columns and chart), and fitted values.
CommandReport beam_report(const model::UniformBeam& beam, const std::vector<model::BeamMode>& modes,
                          const BeamOrigin& origin = {});

/// "torsion", "pinned", …
const char* support_name(model::BeamSupport support);
std::optional<model::BeamSupport> support_named(const std::string& name);

}  // namespace percuss::report
