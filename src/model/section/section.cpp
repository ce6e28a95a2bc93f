#include "model/section/section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/beam/laminate.hpp"

namespace percuss::model {

Material SectionLayer::material(const Material& of_beam) const {
  return {.density_kgpm3 = density_kgpm3.value_or(of_beam.density_kgpm3),
          .young_Pa = young_Pa.value_or(of_beam.young_Pa),
          .shear_Pa = shear_Pa.value_or(of_beam.shear_Pa)};
}

BeamSection round_section(double diameter_m, const std::vector<SectionLayer>& layers, const Material& of_beam) {
  BeamSection sum;
  double outer_m = diameter_m;
  for (const SectionLayer& layer : layers) {
    const double inner_m = std::max(0.0, outer_m - 2 * layer.thickness_m);
    const double outer_m2 = outer_m * outer_m, inner_m2 = inner_m * inner_m;
    const double area_m2 = std::numbers::pi / 4 * (outer_m2 - inner_m2);
    const double second_m4 = area_m2 * (outer_m2 + inner_m2) / 16;
    const Material material = layer.material(of_beam);
    sum.bending_Nm2 += material.young_Pa * second_m4;  // (1)
    sum.shear_N += material.shear_Pa * area_m2;
    sum.mass_kgpm += material.density_kgpm3 * area_m2;
    sum.rotary_kgm += material.density_kgpm3 * second_m4;
    outer_m = inner_m;
  }
  return sum;
}

BeamSection rectangular_section(double width_m, const std::vector<SectionLayer>& layers, const Material& of_beam) {
  std::vector<LaminateLayer> laminate;
  laminate.reserve(layers.size());
  BeamSection sum;
  for (const SectionLayer& layer : layers) {
    const Material material = layer.material(of_beam);
    laminate.push_back({.young_Pa = material.young_Pa,
                        .width_m = width_m,
                        .height_m = layer.thickness_m,
                        .density_kgpm3 = material.density_kgpm3});
    sum.shear_N += material.shear_Pa * width_m * layer.thickness_m;
  }
  const LaminateSection bonded = laminate_section(laminate);
  sum.bending_Nm2 = bonded.stiffness_Nm2;
  sum.mass_kgpm = bonded.mass_per_length_kgpm;
  double under_m = 0;
  for (const LaminateLayer& layer : laminate) {
    const double from_axis_m = under_m + layer.height_m / 2 - bonded.neutral_axis_m;
    sum.rotary_kgm += layer.density_kgpm3 * width_m * layer.height_m *
                      (layer.height_m * layer.height_m / 12 + from_axis_m * from_axis_m);
    under_m += layer.height_m;
  }
  return sum;
}

}  // namespace percuss::model
