#pragma once
#include <vector>

namespace percuss::model {

/// One layer of a beam's section: a rectangle, `width_m` wide across the bending direction.
struct LaminateLayer {
  double young_Pa = 0, width_m = 0, height_m = 0;
  double density_kgpm3 = 0;
};

/// The stiffness and the mass of a section.
struct LaminateSection {
  double stiffness_Nm2 = 0;         // EI
  double mass_per_length_kgpm = 0;  // ρA
  double neutral_axis_m = 0;        // above the underside of the first layer
};

/// Computes the section of bonded layers, the first at the bottom. They bend about a common neutral axis at height
/// z̄; zᵢ is the middle of layer i:
///   EI = Σ (EI)ᵢ,  (EI)ᵢ = Eᵢ bᵢ (hᵢ³/12 + hᵢ (zᵢ − z̄)²),  z̄ = Σ Eᵢ bᵢ hᵢ zᵢ / Σ Eᵢ bᵢ hᵢ      (1)
///   ρA = Σ ρᵢ bᵢ hᵢ                                                                             (2)
/// theory (8.11)
LaminateSection laminate_section(const std::vector<LaminateLayer>& layers);

}  // namespace percuss::model
