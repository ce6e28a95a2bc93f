#pragma once
#include "synth/spec.hpp"

namespace percuss::synth {

/// Transverse shape n = 1, 2, … of a free-free uniform beam at x from one end over its length (0 … 1), 1 at x = 0:
///   X = (cosh βx + cos βx − k (sinh βx + sin βx))/2,  cos β cosh β = 1,  k = (cosh β − cos β)/(sinh β − sin β)
/// computed from decaying exponentials, so that it holds for any n.
double free_beam_shape(int n, double x);

/// Radial mass-normalised shape of a mode at a place of the bat, 1/√kg: a free beam's times cos(θ − angle) for bending;
/// for hoop modes sin(order π position/barrel) cos 2(θ − angle) on the barrel (end cap and taper as nodes) and 0 beyond
/// it.
double mode_shape_per_sqrt_kg(const SynthStructure& structure, const SynthMode& mode, double position_m,
                              double angle_rad);

/// Residue A = φ(impact) φ(sensor) of a mode for an impact point and a sensor, 1/kg, as recorded: with sign and gains.
double residue_per_kg(const SynthSpec& spec, std::size_t mode, std::size_t point, std::size_t sensor);

/// Rigid-body accelerance (1/m + Δ_p Δ_c/I) cos(θ_p − θ_c), Δ from the centre of mass, 1/kg, as recorded.
double rigid_line_per_kg(const SynthSpec& spec, std::size_t point, std::size_t sensor);

}  // namespace percuss::synth
