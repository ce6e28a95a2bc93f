#pragma once
#include <vector>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// Mode indicator function of accelerances at each spectral line:
///   MIF = Σ |Re H| |H| / Σ |H|²  over all FRFs
/// At a mode's frequency an accelerance is imaginary where the mode dominates, so that the function falls towards 0;
/// between modes it is near 1. Unlike the CMIF it shows how real a mode is, not how strong.
/// shapes  result [band.count], 0 … 1, 1 where all FRFs are zero; `band` within set.lines.
/// source  [4] in docs/theory/sources.md.
/// theory (5.9)
std::vector<double> mif(const FrfDataset& set, const acquire::LineRange& band);

}  // namespace percuss::identify
