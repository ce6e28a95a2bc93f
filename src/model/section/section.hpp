#pragma once
#include <limits>
#include <optional>
#include <vector>

namespace percuss::model {

/// A material along the beam. The defaults are the wood of a baseball bat.
struct Material {
  double density_kgpm3 = 649;
  double young_Pa = 1.814e10;
  double shear_Pa = 1.05e9;  // shear modulus × shape factor
};

/// Stiffness and mass of a cross-section.
struct BeamSection {
  double bending_Nm2 = 0;  // EI
  double shear_N = 0;      // κGA
  double mass_kgpm = 0;    // ρA
  double rotary_kgm = 0;   // ρI
};

/// One layer of a section. A constant without a value is the beam's own (Material).
struct SectionLayer {
  double thickness_m = std::numeric_limits<double>::infinity();  // infinite: a round section's layer reaches the axis
  std::optional<double> density_kgpm3{}, young_Pa{}, shear_Pa{};

  Material material(const Material& of_beam) const;
};

/// A round section of bonded concentric layers, the outermost first. With the outer diameters D_i and the inner ones
/// d_i = D_i − 2 t_i, not below 0, and D_(i+1) = d_i:
///   EI = Σ E_i π (D_i⁴ − d_i⁴)/64,  κGA = Σ κG_i π (D_i² − d_i²)/4,  ρA and ρI likewise              (1)
/// The core inside the innermost layer is hollow.
/// theory (12.6)
BeamSection round_section(double diameter_m, const std::vector<SectionLayer>& layers, const Material& of_beam);

/// A rectangular section of bonded layers, the lowest first, that bends across their planes: (1) of laminate.hpp. The
/// rotary inertia is the one about the common neutral axis.
BeamSection rectangular_section(double width_m, const std::vector<SectionLayer>& layers, const Material& of_beam);

}  // namespace percuss::model
