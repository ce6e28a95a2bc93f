#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "identify/hits/mode_windows.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// The single hits of a test.
struct HitFrfs {
  FrfDataset set;                               // a point for each hit; channels hit by hit, their frf empty
  std::vector<std::span<const Complex>> accel;  // [channels of set] spectra of the responses
  std::vector<std::size_t> points;              // [hits] index into FrfDataset::points of the test
};

/// [channels of hits.set] the index of each channel's residue in Mode::residues.
std::vector<std::size_t> residue_indices(const FrfDataset& set, const HitFrfs& hits);

/// The FRFs of the single hits over a window, without the modes outside it: [channels of hits.set][window.count].
/// modes_in_hits  the same modes with the residues of the single hits, [channels of hits.set]; empty: each hit has the
///                residues of the test
std::vector<Eigen::VectorXcd> hit_data(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes,
                                       const ModeWindow& window, const std::vector<Mode>& modes_in_hits = {});

}  // namespace percuss::identify
