#pragma once
#include <cstddef>
#include <set>
#include <vector>

#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/hits/hit_spectra.hpp"

namespace percuss::pipeline {

/// [indices of hits] the accepted hits with the finding `low_coherence` that disagree with the other hits of their
/// point only by noise. The part of their responses that the other hits do not explain has at most four times the
/// energy of the noise before the hit on the same spectral lines, all channels together. Hits whose noise is not known
/// (fewer than 16 samples before the hit, or motion there) are not among them.
std::set<std::size_t> hits_that_differ_by_noise(const std::vector<AnalysedHit>& hits, const HitResponses& responses,
                                                const TransformOptions& options);

/// [indices of hits] the accepted hits with the finding `low_coherence` that excite little, because their point lies on
/// the node line of a strong mode. Hits slightly beside the point excite this mode with either sign, so they disagree.
/// The part of their responses that the other hits do not explain has at most 2 % of the energy that the upper quartile
/// of the accepted hits excites, each relative to the square of the force's peak. Such a part does not change the modes
/// at other points.
std::set<std::size_t> hits_on_node_lines(const std::vector<AnalysedHit>& hits, const HitResponses& responses);

}  // namespace percuss::pipeline
