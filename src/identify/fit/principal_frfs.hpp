#pragma once
#include <Eigen/Core>
#include <cstddef>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// Real orthogonal sums of a large set's channels over their noise, those that hold what stands out of it: no more than
/// `most`. A set of m modes spans m of them, so that next to nothing of what the channels know of the poles is lost.
/// shape [channels, sums]
Eigen::MatrixXd principal_components(const FrfDataset& set, std::size_t most);

/// The channels of a set mixed by such sums; real residues stay real. The mixed channels count as answers to one point
/// whose force is without noise and whose records hold the whole decay.
FrfDataset principal_frfs(const FrfDataset& set, const Eigen::MatrixXd& sums);

}  // namespace percuss::identify
