#pragma once
#include <span>
#include <vector>

#include "core/math/fft.hpp"
#include "pipeline/analysed_hit.hpp"

namespace percuss::pipeline {

/// A hit's transforms; empty for hits that take no part.
struct HitSpectra {
  std::span<const Complex> force;
  std::vector<std::span<const Complex>> accel;  // [channels]
};

/// Compares the accepted hits of each point with one another: adds `outlier` (and takes the hit out) where one
/// disagrees with the others far more than they do among themselves, and `low_coherence` where the others explain less
/// than 90 % of its response.
void grade_agreement(std::vector<AnalysedHit>& hits, const std::vector<HitSpectra>& spectra);

/// Lets the accepted hits of each point vote on which way a channel first moves, relative to the push. Hits that say
/// otherwise lose their `polarity` and `delay_s`; all do when more than a fifth of them disagree.
void vote_first_motion(std::vector<AnalysedHit>& hits);

}  // namespace percuss::pipeline
