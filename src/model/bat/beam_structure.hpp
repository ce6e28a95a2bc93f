#pragma once
#include <vector>

#include "model/beam/beam.hpp"
#include "model/section/section_table.hpp"

namespace percuss::model {

/// A mass without stiffness on a beam, such as a grip, a cap or an insert: spread evenly over a stretch, or a point
/// mass where both ends are equal. It has no rotary inertia of its own.
struct AddedMass {
  double mass_kg = 0;
  double from_m = 0, to_m = 0;
};

/// A support at one position of a beam. At a pin or a clamp the deflection is zero, at a clamp the rotation as well.
struct StructureSupport {
  BeamSupport kind = BeamSupport::free;
  double at_m = 0;
  double torsion_Nmprad = 0;  // of BeamSupport::torsion
};

/// A straight beam or bat with the sections of a table.
struct BeamStructure {
  SectionTable table;
  Material material;  // where a layer has no constants of its own
  std::vector<AddedMass> added{};
  StructureSupport support{};
  bool slender = false;  // Euler–Bernoulli: without shear and rotary inertia

  double length_m() const { return table.length_m(); }
};

/// The density of the beam's own material with which the whole beam, added masses included, has the mass total_kg:
///   ρ = (m − m_fixed)/V,  V = ∂m/∂ρ                                                                    (1)
/// errors  InputError where no layer has that density, or where the other parts weigh total_kg or more.
double density_for_mass(const BeamStructure& structure, double total_kg);

}  // namespace percuss::model
