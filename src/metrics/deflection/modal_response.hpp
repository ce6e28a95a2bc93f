#pragma once
#include <complex>
#include <span>
#include <vector>

#include "identify/model/mode.hpp"

namespace percuss::metrics {

/// A mode's contribution to the FRF of one impact point and one sensor.
struct ModalContribution {
  identify::Pole pole;
  std::complex<double> residue_per_kg;
  double residue_std_per_kg = 0;  // of the real and of the imaginary part
  double gain_std = 0;            // of the gain common to all modes of the point, over its value
};

/// The deflection of a structure at rest under a force: a sum over its modes and its rigid-body motion. The residues
/// belong to the accelerance A·s²/(s² + 2ζω_r s + ω_r²):
///   W(s) = F(s) [Σ_r (a/(s − s_r) + conj(a)/(s − conj(s_r))) + 1/(m s²)],  a = A/(2jω_d)      (1)
/// shapes [samples]; std_m includes the residues, their common gain and the noise of the force while it acts.
/// theory (7.8)
struct ModalDeflection {
  std::vector<double> accel_mps2, velocity_mps, deflection_m, std_m;
};
/// rigid_per_kg: 1/m of (1), the rigid-body accelerance at the point; 0 for a held structure. force_noise_N: standard
/// deviation of a sample of the force between its first and last sample other than zero.
ModalDeflection modal_deflection(std::span<const double> force_N, double fs_Hz,
                                 const std::vector<ModalContribution>& modes, double rigid_per_kg,
                                 double force_noise_N = 0);

}  // namespace percuss::metrics
