#pragma once
#include <cstddef>
#include <vector>

#include "identify/fit/windowed_fit.hpp"

namespace percuss {

/// Whether a fitted pole is a mode of the structure or of the noise and the model's own misfit.
struct CredibilityContext {
  std::vector<Pole> shown;  // poles that began as a peak of their own
  bool settled = false;     // no more modes will be added: what is left over is misfit
};

/// How far the mode's own peak stands out of what the window's fit leaves, at the output where it does most.
double stands_out(const GroupedFit& all, const FitGroup& group, std::size_t mode);

/// A mode is credible when it lies within its window, is determined (deviations below its own width and damping; below
/// a third of the damping where it hardly decays within the record), has a residue that is significant somewhere, and
/// stands out: further when it showed no peak of its own and the residual is more than noise, and further where the
/// hammer did not reach.
bool credible(const GroupedFit& all, const FitGroup& group, std::size_t mode, const CredibilityContext& context);

/// Two poles that a fit has pushed into one: nothing tells their residues apart any more. Where nothing is known of the
/// force, and so of the records' ends and windows, poles within one line are the shape of one resonance.
bool coincide(const GroupedFit& all, const Pole& a, const Pole& b);

/// Every mode of the group credible, and no two of them one bent line: apart by half the narrower one's width.
bool all_credible(const GroupedFit& all, const FitGroup& group, const CredibilityContext& context);

}  // namespace percuss
