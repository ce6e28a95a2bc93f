#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// Close modes and the window of spectral lines around them.
struct ModeWindow {
  std::vector<std::size_t> modes;  // indices, ascending in frequency
  std::size_t first = 0, count = 0;
  std::vector<Pole> poles(const std::vector<Mode>& all) const;
};

/// The windows of modes in ascending frequency, as WindowedFit places them.
std::vector<ModeWindow> mode_windows(const FrfDataset& set, const std::vector<Mode>& modes);

/// The lines within `reach` lines of a frequency, and the modes among them.
ModeWindow window_around(const FrfDataset& set, const std::vector<Mode>& modes, double freq_Hz, double reach);

/// Subtracts the modes outside a window. `data` [channels of set][window.count]; residue_of[o] is the index of channel
/// o's residue in Mode::residues.
void subtract_other_modes(const FrfDataset& set, const std::vector<Mode>& modes, const ModeWindow& window,
                          const std::vector<std::size_t>& residue_of, std::vector<Eigen::VectorXcd>& data);

/// The FRFs of `set` over a window, without the modes outside it: [channels of set][window.count].
std::vector<Eigen::VectorXcd> window_data(const FrfDataset& set, const std::vector<Mode>& modes,
                                          const ModeWindow& window);

/// The same data as an FRF dataset, with the force at these lines.
FrfDataset frfs_within(const FrfDataset& set, const std::vector<Mode>& modes, const ModeWindow& window);

}  // namespace percuss::identify
