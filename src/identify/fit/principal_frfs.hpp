#pragma once
#include <Eigen/Core>
#include <cstddef>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// Principal components of the FRFs divided by their noise, from the lines above the noise: the `max_components` real
/// orthogonal combinations with the most energy (all where there are fewer FRFs). m modes span m components, so that
/// almost no information about the poles is lost. shape  [channels, components]
Eigen::MatrixXd principal_components(const FrfDataset& set, std::size_t max_components);

/// The FRFs of the principal components; real residues stay real. They count as FRFs of one impact point with a
/// noise-free force and without truncation.
FrfDataset principal_frfs(const FrfDataset& set, const Eigen::MatrixXd& components);

}  // namespace percuss::identify
