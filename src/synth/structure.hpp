#pragma once
#include "synth/spec.hpp"

namespace percuss::synth {

/// Transverse shape n = 1, 2, … of a free-free uniform beam at x = 0 … 1 along its length, scaled to 1 at x = 0:
///   X = (cosh βx + cos βx − k (sinh βx + sin βx))/2,  cos β cosh β = 1,  k = (cosh β − cos β)/(sinh β − sin β)
/// It is computed from decaying exponentials, so it is accurate for any n.
double free_beam_shape(int n, double x);

/// Radial mass-normalised shape of a mode at a point of the bat, 1/√kg. Bending: the shape of a free beam times
/// cos(θ − angle). Hoop: sin(order π position/barrel) cos 2(θ − angle) on the barrel (nodes at end cap and taper), and
/// 0 beyond it.
double mode_shape_per_sqrt_kg(const SynthStructure& structure, const SynthMode& mode, double position_m,
                              double angle_rad);

/// Recorded residue A = φ(impact) φ(sensor) of a mode for an impact point and a sensor, 1/kg, with sign and gains.
double residue_per_kg(const SynthSpec& spec, std::size_t mode, std::size_t point, std::size_t sensor);

/// Recorded rigid-body accelerance (1/m + Δ_p Δ_c/I) cos(θ_p − θ_c), Δ from the centre of mass, 1/kg.
double rigid_line_per_kg(const SynthSpec& spec, std::size_t point, std::size_t sensor);

}  // namespace percuss::synth
