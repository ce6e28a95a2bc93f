#pragma once
#include <complex>
#include <span>
#include <vector>

#include "identify/model/mode.hpp"

namespace percuss::metrics {

/// A mode as one sensor sees it from one impact point.
struct ModalContribution {
  identify::Pole pole;
  std::complex<double> residue_per_kg;
  double residue_std_per_kg = 0;  // of the real and of the imaginary part
};

/// Deflection that a force makes of a structure at rest: the sum of its modes' (and of a rigid body's), whose residues
/// are those of the accelerance A·s²/(s² + 2ζω_r s + ω_r²):
///   W(s) = F(s) [Σ_r (a/(s − s_r) + conj(a)/(s − conj(s_r))) + 1/(m s²)],  a = A/(2jω_d)      (1)
/// force_N and results [samples]; std_m from the residues' deviations alone.
/// theory (7.8)
struct ModalDeflection {
  std::vector<double> accel_mps2, velocity_mps, deflection_m, std_m;
};
/// rigid_per_kg: 1/m of (1), the accelerance of the free body at the point; 0 for a structure that is held.
ModalDeflection modal_deflection(std::span<const double> force_N, double fs_Hz,
                                 const std::vector<ModalContribution>& modes, double rigid_per_kg);

}  // namespace percuss::metrics
