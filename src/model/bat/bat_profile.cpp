#include "model/bat/bat_profile.hpp"

#include <cstddef>

namespace percuss::model {

BeamStructure structure_of(const BatProfile& profile, const BatMaterial& material) {
  BeamStructure bat{.table = {}, .material = material};
  bat.table.stations.reserve(profile.end_m.size());
  for (std::size_t i = 0; i < profile.end_m.size(); ++i)
    bat.table.stations.push_back({.at_m = profile.end_m[i], .width_m = profile.diameter_m[i], .layers = {{}}});
  return bat;
}

}  // namespace percuss::model
