#pragma once
#include <cstddef>
#include <vector>

#include "identify/fit/windowed_fit.hpp"

namespace percuss::identify {

/// Whether a fitted pole is a mode of the structure or of the noise and the model's own misfit.
struct AcceptanceContext {
  std::vector<Pole> peak_poles;  // poles that began as a peak of their own
  bool search_finished = false;  // no more modes will be added: what is left over is misfit
};

/// How far the mode's own peak stands out of what the window's fit leaves, at the channel where it does most.
double peak_to_residual(const WindowedFit& all, const FitGroup& group, std::size_t mode);

/// A mode is credible when it lies within its window, is determined (deviations below its own width and damping; below
/// a third of the damping where it hardly decays within the record), has a residue that is significant somewhere, and
/// stands out: further when it showed no peak of its own and the residual is more than noise, and further where the
/// hammer did not reach.
bool accept_mode(const WindowedFit& all, const FitGroup& group, std::size_t mode, const AcceptanceContext& context);

/// Two poles that a fit has pushed into one: nothing tells their residues apart any more. Where nothing is known of the
/// force, and so of the records' ends and windows, poles within one line are the shape of one resonance.
bool poles_coincide(const WindowedFit& all, const Pole& a, const Pole& b);

/// Every mode of the group credible, and no two of them one bent line: apart by half the narrower one's width.
bool accept_all_modes(const WindowedFit& all, const FitGroup& group, const AcceptanceContext& context);

}  // namespace percuss::identify
