#pragma once
#include <optional>
#include <vector>

#include "model/beam/beam.hpp"
#include "model/beam/beam_fit.hpp"
#include "report/command_report.hpp"

namespace percuss {

/// What the beam's values came from, where not from the user alone.
struct BeamOrigin {
  std::optional<BeamFit> fit;
  std::vector<MeasuredFrequency> measured;  // that the fit is to
  std::optional<TorsionFit> torsion;        // from static readings
};

/// percuss/model-beam/1: frequencies, nodes, shapes (as columns and chart), and what was fitted.
CommandReport beam_report(const UniformBeam& beam, const std::vector<BeamMode>& modes, const BeamOrigin& origin = {});

/// "torsion", "pinned", …: as on the command line.
const char* support_name(BeamSupport support);
std::optional<BeamSupport> support_named(const std::string& name);

}  // namespace percuss
