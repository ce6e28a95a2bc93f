#include "identify/select/finished_modes.hpp"

#include <utility>

#include "identify/select/common_residues.hpp"
#include "identify/select/local_force_noise.hpp"

namespace percuss::identify {

std::vector<Mode> finished_modes(const FrfDataset& set, std::vector<FittedMode> found) {
  add_force_noise(set, found);
  fit_common_residues(set, found);
  std::vector<Mode> modes;
  modes.reserve(found.size());
  for (FittedMode& mode : found) modes.push_back(std::move(mode.mode));
  return modes;
}

}  // namespace percuss::identify
