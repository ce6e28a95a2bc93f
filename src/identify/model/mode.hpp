#pragma once
#include <complex>
#include <optional>
#include <vector>

#include "identify/model/hit_trend.hpp"
#include "identify/model/modal_model.hpp"
#include "identify/model/std_parts.hpp"

namespace percuss::identify {

/// Relative accuracy of transforms and fits in double precision, of a frequency and of a damping ratio.
inline constexpr double kRounding = 1e-12;
inline constexpr double kRoundingDamping = 1e-9;

/// A residue is significant from this many standard deviations on.
inline constexpr double kSignificant = 3;

/// A mode's residue in one FRF: accelerance H(ω) = … + A·(jω)²/((jω)² + 2ζω_r jω + ω_r²), 1/kg.
/// theory (3.2)
struct Residue {
  std::size_t point = 0;
  std::size_t channel = 0;
  Complex value;
  double std = 0;                // of the real part and of the imaginary part
  double relative_std = 0;       // over |value|, common to the point's FRFs: the force's noise, scatter of the hits
  std::optional<Pole> own_pole;  // the pole at this point, where the frequency scatters between the points
};

/// An identified mode, with one standard deviation of each value.
struct Mode {
  Pole pole;
  double freq_std_Hz = 0;
  double damping_std = 0;
  StdParts freq_std_parts_Hz, damping_std_parts;
  double hit_scatter_Hz = 0;  // standard deviation of the frequency between hits, beyond the noise; 0: none
  double hit_scatter_damping = 0;
  // p-value: noise alone makes the hits differ as much. 1: not significant; the scatter then comes from other modes.
  double hit_scatter_freq_p = 1;
  double hit_scatter_damping_p = 1;
  std::optional<AmplitudeTrend> amplitude;  // where the force explains the scatter between the hits
  std::optional<DriftTrend> drift;          // where the order of the hits explains it
  double freq_scatter_Hz = 0;     // standard deviation of the frequency between impact points; 0: not significant
  std::vector<Residue> residues;  // [channels] in the order of FrfDataset::channels
  /// Where the mode keeps its windowed fit: residual energy of the joint fit around this mode over the residual energy
  /// of the windowed fit. Infinite where the poles of the joint fit did not settle in its first pass, before its
  /// weights follow from the residual. Otherwise 0.
  double joint_misfit = 0;
  double joint_residual = 0;  // of the joint fit, relative to the FRFs around the mode
};

}  // namespace percuss::identify
