#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/classify/ratio_likelihood.hpp"

namespace percuss::identify {

/// Posterior probabilities of the types, in the order bending, hoop, other.
using TypePosterior = std::array<double, 3>;

/// The evidence for one mode: the ratio (none where the first sensor has no residue, or no point has both sensors) and
/// the partner: a mode that may be the same one in the other plane.
struct TypeEvidence {
  double freq_Hz = 0;
  double size = 1;  // of both sensors' residues together, in any unit
  std::optional<RatioAngle> ratio;
  std::optional<std::size_t> partner;  // index of the partner, whose own `partner` is this mode
};

/// The type posteriors of all modes of one test, in ascending frequency. The modes share two unknowns: the plane in
/// which the bat is most flexible, and the placement, which is the error of the angle between the sensors. With their
/// prior weights w, and the likelihood L of each type f of each mode at given unknowns,
///   P(f of mode m) ∝ Σ_plane,placement w · L_m(f) Π_others Σ_f' L(f')                                     (1)
/// Modes that all have the hoop ratio may therefore all be bending modes in a plane at −45° to the first sensor. The
/// prior favours this if the lowest frequency is low, because a bat's lowest mode is a bending mode. The two planes of
/// one bending mode are at right angles. Both members of a hoop pair have the hoop ratio. A hammer at an unknown angle
/// φ from an antinode of one member excites the two as cos 2φ : sin 2φ.
/// theory (6.6)
std::vector<TypePosterior> type_posteriors(const std::vector<TypeEvidence>& modes, const RatioLikelihood& likelihood);

/// Natural logarithm of the evidence for the sensors' set-up: the denominator of (1), which is the sum over all types
/// of all modes, planes and placements. It is the mean over two kinds of tubes: one with planes of its own, as in (1),
/// and a round one whose bending modes all lie in the plane of the blow. The lower the frequency of a mode is, the
/// smaller is its prior probability of being a hoop mode. Only differences between set-ups of the same modes have a
/// meaning.
/// theory (6.8)
double log_set_up_evidence(const std::vector<TypeEvidence>& modes, const RatioLikelihood& likelihood);

}  // namespace percuss::identify
