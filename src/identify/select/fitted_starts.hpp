#pragma once
#include <vector>

#include "identify/model/modal_model.hpp"
#include "identify/select/fitted_mode.hpp"
#include "identify/select/sequential_fit.hpp"

namespace percuss::identify {

/// A start whose fit is no mode, with the values of this fit.
struct RefusedStart {
  enum class Reason {
    moved,         // by more than its bandwidth
    undamped,      // the damping ratio is consistent with zero
    no_resonance,  // no peak above the residual around it
  };
  double asked_Hz = 0;
  Pole pole;
  double damping_std = 0;
  double peak_to_residual = 0;
  Reason reason = Reason::moved;
};

/// The modes fitted from the accepted starts, and the refused starts.
struct FittedStarts {
  std::vector<FittedMode> modes;
  std::vector<RefusedStart> refused;
};

/// At most one mode from each start. A start is refused where its fit moves away, does not decay or shows no resonance.
/// The other modes are then fitted without it.
FittedStarts fit_starts(const FrfDataset& set, std::vector<double> start_Hz, Effort effort);

}  // namespace percuss::identify
