#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/classify/ratio_likelihood.hpp"

namespace percuss::identify {

/// Probabilities of the readings, in the order bending, hoop, neither.
using TypePosterior = std::array<double, 3>;

/// What is known of one mode: its ratio (nothing where no sensor sees it) and the other half of a close pair.
struct TypeEvidence {
  double freq_Hz = 0;
  double size = 1;  // of both sensors' residues together, any unit
  std::optional<RatioAngle> ratio;
  std::optional<std::size_t> partner;  // mutual
};

/// The readings of all modes of one test (ascending in frequency), judged together, because they share what is not
/// known: the plane in which the bat is weakest and how far the sensors' distance is off. With weights w of both, and
/// of each mode its likelihood L of every reading f under them,
///   P(f of mode m) ∝ Σ_plane,placement w · L_m(f) Π_others Σ_f' L(f')                                     (1)
/// So modes that all look like hoop modes may as well all bend at −45° to the sensors, the more so as the lowest mode
/// of a bat bends. Two planes of one bending mode are at right angles; both halves of a hoop pair have the
/// hoop ratio; and a hammer at an unknown angle λ to such a pair excites its halves as cos λ : sin λ.
/// theory (6.6)
std::vector<TypePosterior> type_posteriors(const std::vector<TypeEvidence>& modes, const RatioLikelihood& likelihood);

}  // namespace percuss::identify
