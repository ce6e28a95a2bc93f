#pragma once
#include <vector>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// Poles that the LSCF estimator finds again and again as its model order grows, from all FRFs together, ascending. The
/// band is taken whole and in halves, quarters … that overlap by half: a short section separates crowded modes, a long
/// one holds broad modes. The poles are start values of fits. A few come from noise: the fit decides.
/// source  [6], [11] in docs/theory/sources.md.
/// theory (4.7)
std::vector<Pole> stable_poles(const FrfDataset& set);

/// True for two poles within half a bandwidth and of similar bandwidth: two estimates of one mode.
bool same_place(const Pole& a, const Pole& b);

}  // namespace percuss::identify
