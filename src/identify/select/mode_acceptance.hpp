#pragma once
#include <cstddef>
#include <vector>

#include "identify/fit/windowed_fit.hpp"

namespace percuss::identify {

/// The state of the search, for the acceptance of a fitted pole as a mode of the structure.
struct AcceptanceContext {
  std::vector<Pole> peak_poles;  // poles at which the search started: one per peak or per stated start
  bool search_finished = false;  // no more modes will be added: the residual is misfit
};

/// The mode's peak over the rms residual of the window's fit, the largest ratio over the FRFs.
double peak_to_residual(const WindowedFit& all, const FitGroup& group, std::size_t mode);

/// True for a mode of the structure. Its pole lies within its window, and its damping is plausible. The standard
/// deviation of its frequency is below its bandwidth. The standard deviation of its damping is below the damping, or
/// below a third of it where the mode hardly decays within the record. In an FRF whose residue is significant, its peak
/// stands out of the force's noise. In some FRF, its peak stands out of the residual, and in some, of the fit's model
/// error. The required ratio rises for a mode without a peak of its own whose window misfits, and above the force's
/// bandwidth.
bool accept_mode(const WindowedFit& all, const FitGroup& group, std::size_t mode, const AcceptanceContext& context);

/// True for two poles that a fit has merged, so that their residues cannot be distinguished. Where the force is
/// unknown, truncation and window are unknown as well: poles within one line then count as one resonance.
bool poles_coincide(const WindowedFit& all, const Pole& a, const Pole& b);

/// True where every mode of the group is accepted, and any two are at least half a bandwidth apart (a twentieth where
/// the residual is only noise).
bool accept_all_modes(const WindowedFit& all, const FitGroup& group, const AcceptanceContext& context);

}  // namespace percuss::identify
