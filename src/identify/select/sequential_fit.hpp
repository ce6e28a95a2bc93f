#pragma once
#include <vector>

#include "identify/fit/windowed_fit.hpp"
#include "identify/model/effort.hpp"
#include "identify/select/fitted_mode.hpp"

namespace percuss::identify {

struct SequentialFitOptions {
  int max_rounds = 6;           // changes of the set of modes, each followed by a fit
  bool search_residual = true;  // look for modes without a peak of their own
  WindowedFitOptions windows;
  std::vector<double> start_Hz;  // fit exactly one mode from each of these frequencies
  std::vector<Pole> start;       // fit from these poles of an earlier fit, and keep the accepted ones
  bool keep_all = false;         // keep every mode fitted from `start`
  bool settle = false;           // fit the modes found until no group changes: no joint fit follows
};
/// The search that each effort makes.
SequentialFitOptions sequential_fit_options(Effort effort);

/// Modes from peaks. Each prominent maximum of the summed FRFs is fitted over a window of spectral lines, with the
/// other modes' contributions subtracted; close modes are fitted together. A search then changes the set of modes until
/// it settles: insignificant modes are dropped, a group that misfits receives a second mode, and the residual of the
/// whole band shows modes without a peak. Standard deviations are scaled by each window's residual. Modes in ascending
/// frequency.
std::vector<FittedMode> fit_sequentially(const FrfDataset& set, const SequentialFitOptions& options = {});

}  // namespace percuss::identify
