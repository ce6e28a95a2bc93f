#include "model/beam/laminate.hpp"

namespace percuss::model {

LaminateSection laminate_section(const std::vector<LaminateLayer>& layers) {
  LaminateSection section;
  double below_m = 0, axial_stiffness_N = 0, first_moment_Nm = 0;
  for (const LaminateLayer& layer : layers) {
    const double axial_N = layer.young_Pa * layer.width_m * layer.height_m;
    axial_stiffness_N += axial_N;
    first_moment_Nm += axial_N * (below_m + layer.height_m / 2);
    below_m += layer.height_m;
  }
  section.neutral_axis_m = first_moment_Nm / axial_stiffness_N;
  below_m = 0;
  for (const LaminateLayer& layer : layers) {
    const double h = layer.height_m, arm_m = below_m + h / 2 - section.neutral_axis_m;
    section.stiffness_Nm2 += layer.young_Pa * layer.width_m * h * (h * h / 12 + arm_m * arm_m);  // (1)
    section.mass_per_length_kgpm += layer.density_kgpm3 * layer.width_m * h;                     // (2)
    below_m += h;
  }
  return section;
}

}  // namespace percuss::model
