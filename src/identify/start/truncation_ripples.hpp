#pragma once
#include <vector>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// Where a decay is cut off by the record's end, its resonance has ripples on its flanks, as every hit lacks something
/// else; they look like peaks. [poles] true for those that are no higher than such a flank: they may be its ripples.
std::vector<char> find_truncation_ripples(const FrfDataset& set, const std::vector<Pole>& poles);

/// True when a good part of what is measured at the pole's line is still left in the residual, [channels][lines].
bool remains_in_residual(const FrfDataset& set, const Pole& pole, const std::vector<Eigen::VectorXcd>& residual);

}  // namespace percuss::identify
