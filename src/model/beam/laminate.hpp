#pragma once
#include <vector>

namespace percuss::model {

/// One layer of a beam's section: a rectangle as wide as `width_m`, across the bending.
struct LaminateLayer {
  double young_Pa = 0, width_m = 0, height_m = 0;
  double density_kgpm3 = 0;
};

/// A section's stiffness and mass.
struct LaminateSection {
  double stiffness_Nm2 = 0;         // EI
  double mass_per_length_kgpm = 0;  // ρA
  double neutral_axis_m = 0;        // above the underside of the first layer
};

/// Layers glued on each other from the first up, bending about their common neutral axis, at the height z̄:
///   EI = Σ (EI)ᵢ,  (EI)ᵢ = Eᵢ bᵢ (hᵢ³/12 + hᵢ (zᵢ − z̄)²),  z̄ = Σ Eᵢ bᵢ hᵢ zᵢ / Σ Eᵢ bᵢ hᵢ      (1)
///   ρA = Σ ρᵢ bᵢ hᵢ                                                                             (2)
/// theory (8.11)
LaminateSection laminate_section(const std::vector<LaminateLayer>& layers);

}  // namespace percuss::model
