#pragma once
#include <cstddef>
#include <vector>

#include "identify/fit/variable_projection.hpp"
#include "identify/hits/hit_frfs.hpp"

namespace percuss::identify {

/// A mode's residue in one hit over its residue in the test, and the weight of that ratio, one over its variance. A
/// weight of 0: the hit does not determine it.
struct ResidueRatio {
  double sum = 0, weight = 0;
  double value() const { return sum / weight; }
};

/// The ratios of one mode, [hits]: real, and common to all channels. A hit beside its place, in another direction or
/// with another gain of the force changes the residues of all channels by one factor.
/// `state`: the fit of the single hits at the modes' poles; `at`: the mode's place among these poles; `freedom`: the
/// degrees of freedom of a channel's residual.
std::vector<ResidueRatio> residue_ratios(const HitFrfs& hits, const ProjectedState& state, const Mode& mode,
                                         const std::vector<std::size_t>& residue_of, Eigen::Index at, double freedom);

}  // namespace percuss::identify
