#include "model/bat/bat_profile.hpp"

#include <cstddef>
#include <numbers>

namespace percuss::model {

BatInertia inertia_of(const BatProfile& profile, const BatMaterial& material) {
  BatInertia sum;
  double about_knob = 0, start_m = 0;
  for (std::size_t i = 0; i < profile.end_m.size(); ++i) {
    const double element_length_m = profile.end_m[i] - start_m, middle_m = start_m + element_length_m / 2;
    const double square_m2 = profile.diameter_m[i] * profile.diameter_m[i];
    const double slice_kg = material.density_kgpm3 * std::numbers::pi / 4 * square_m2 * element_length_m;
    sum.mass_kg += slice_kg;
    sum.cm_m += slice_kg * middle_m;
    about_knob += slice_kg * (middle_m * middle_m + element_length_m * element_length_m / 12 + square_m2 / 16);
    start_m = profile.end_m[i];
  }
  sum.cm_m /= sum.mass_kg;
  sum.inertia_kgm2 = about_knob - sum.mass_kg * sum.cm_m * sum.cm_m;
  return sum;
}

}  // namespace percuss::model
