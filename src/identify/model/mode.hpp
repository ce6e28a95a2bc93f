#pragma once
#include <complex>
#include <optional>
#include <vector>

#include "identify/model/modal_model.hpp"

namespace percuss::identify {

/// What transforms and fits in double precision are good for: of a frequency, and of a damping ratio.
inline constexpr double kRounding = 1e-12;
inline constexpr double kRoundingDamping = 1e-9;

/// Deviations from which a residue is told from nothing.
inline constexpr double kSignificant = 3;

/// A mode's residue at one channel: accelerance H(ω) = … + A·(jω)²/((jω)² + 2ζω_r jω + ω_r²), 1/kg.
/// theory (3.2)
struct Residue {
  std::size_t point = 0;
  std::size_t channel = 0;
  Complex value;
  double std = 0;           // of the real and of the imaginary part
  double relative_std = 0;  // of what all channels of the point share (the force's own noise), as a fraction of |value|
  std::optional<Pole> own_pole;  // the point's, where points disagree beyond doubt and this one sees the mode
};

/// An identified mode with one standard deviation on everything.
struct Mode {
  Pole pole;
  double freq_std_Hz = 0;
  double damping_std = 0;
  double freq_scatter_Hz =
      0;  // standard deviation of the frequency between impact points, where they disagree beyond doubt
  std::vector<Residue> residues;  // [channels], in the order of FrfDataset::channels
};

}  // namespace percuss::identify
