#pragma once
#include <optional>
#include <vector>

#include "model/beam/beam.hpp"
#include "model/beam/beam_fit.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// What the beam's values came from, where not from the user alone.
struct BeamOrigin {
  std::optional<model::BeamFit> fit;
  std::vector<model::MeasuredFrequency> measured;  // that the fit is to
  std::optional<model::TorsionFit> torsion;        // from static readings
};

/// percuss/model-beam/1: frequencies, nodes, shapes (as columns and chart), and what was fitted.
CommandReport beam_report(const model::UniformBeam& beam, const std::vector<model::BeamMode>& modes,
                          const BeamOrigin& origin = {});

/// "torsion", "pinned", …: as on the command line.
const char* support_name(model::BeamSupport support);
std::optional<model::BeamSupport> support_named(const std::string& name);

}  // namespace percuss::report
