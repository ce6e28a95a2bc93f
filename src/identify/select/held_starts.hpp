#pragma once
#include <vector>

#include "identify/model/modal_model.hpp"
#include "identify/select/fitted_mode.hpp"
#include "identify/select/sequential_fit.hpp"

namespace percuss::identify {

/// A starting frequency whose fit is no mode, and where that fit went.
struct RefusedStart {
  enum class Reason {
    moved,         // by more than its bandwidth
    undamped,      // the damping ratio is consistent with zero
    no_resonance,  // no peak above what the fit leaves around it
  };
  double asked_Hz = 0;
  Pole pole;
  double damping_std = 0;
  double peak_to_residual = 0;
  Reason reason = Reason::moved;
};

struct HeldStarts {
  std::vector<FittedMode> modes;
  std::vector<RefusedStart> refused;
};

/// At most one mode from each starting frequency. A fit has to hold on to its place: where it moved away, does not
/// decay or shows no resonance, the start is refused, and the other modes are fitted without it.
HeldStarts fit_held_starts(const FrfDataset& set, std::vector<double> start_Hz, Effort effort);

}  // namespace percuss::identify
