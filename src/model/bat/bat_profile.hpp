#pragma once
#include <vector>

namespace percuss::model {

/// A bat of round slices, from the end of the knob (0) on. shapes: both of the same length, at least one.
struct BatProfile {
  std::vector<double> end_m;       // far end of each slice, ascending
  std::vector<double> diameter_m;  // above zero

  double length_m() const { return end_m.back(); }
};

struct BatMaterial {
  double density_kgpm3 = 649;
  double young_Pa = 1.814e10;
  double shear_Pa = 1.05e9;  // shear modulus × shape factor
};

/// The rigid-body properties of a bat.
struct BatInertia {
  double mass_kg = 0;
  double cm_m = 0;          // centre of mass, from the end of the knob
  double inertia_kgm2 = 0;  // about a transverse axis through the centre of mass; slices as solid cylinders
};

BatInertia inertia_of(const BatProfile& profile, const BatMaterial& material);

}  // namespace percuss::model
