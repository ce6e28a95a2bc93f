#include "model/bat/struck_modes.hpp"

#include <algorithm>

#include "core/units.hpp"

namespace percuss::model {

std::vector<StruckMode> struck_modes(const BatModes& beam, double at_m, std::size_t modes) {
  std::vector<StruckMode> struck;
  const auto rigid = static_cast<Eigen::Index>(rigid_body_modes(beam.support.kind));
  const Eigen::VectorXd motion = beam.rigid_deflection(at_m).tail(rigid), shape = beam.deflection(at_m);
  for (const double weight : motion) struck.push_back({.omega_radps = 0, .weight = weight});
  for (Eigen::Index i = 0; i < shape.size(); ++i)
    struck.push_back({.omega_radps = kTwoPi * beam.freq_Hz[i], .weight = shape[i]});
  struck.resize(std::min(struck.size(), modes));
  return struck;
}

}  // namespace percuss::model
