#pragma once
#include <vector>

#include "identify/hits/mode_windows.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// Corrects the residues of close modes after their poles have moved from `before`. Each residue gets the difference
/// between its least-squares value over the window at the new poles and at the old poles. Residues of close modes are
/// large and cancel one another in part; at another distance of the poles they describe no measured FRF. Separate modes
/// keep their residues: an average of different resonances is broader than each of them, but has their residue. Real
/// residues stay real.
void move_residues(const FrfDataset& set, const ModeWindow& window, const std::vector<Pole>& before,
                   std::vector<Mode>& modes);

}  // namespace percuss::identify
