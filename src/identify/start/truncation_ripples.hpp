#pragma once
#include <vector>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// A decay that the record's end truncates leaves ripples on the flanks of its resonance, which look like peaks.
/// [poles] true for the peaks that are lower than twice such a flank, and so may be ripples.
std::vector<char> find_truncation_ripples(const FrfDataset& set, const std::vector<Pole>& poles);

/// True where the residual, [channels][lines], still holds a large part of the energy at the pole's line.
bool remains_in_residual(const FrfDataset& set, const Pole& pole, const std::vector<Eigen::VectorXcd>& residual);

}  // namespace percuss::identify
