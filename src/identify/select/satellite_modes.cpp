#include "identify/select/satellite_modes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "identify/model/close_poles.hpp"
#include "identify/select/joint_refinement.hpp"

namespace percuss::identify {
namespace {

constexpr double kTiny = 0.02;  // of the residues of the mode beside it

double size_of(const FittedMode& mode) {
  double squares = 0;
  for (const Residue& residue : mode.mode.residues) squares += std::norm(residue.value);
  return std::sqrt(squares);
}

bool is_satellite(const FittedMode& mode, const std::vector<FittedMode>& modes) {
  return std::any_of(modes.begin(), modes.end(), [&](const FittedMode& other) {
    return are_close(mode.mode.pole, other.mode.pole) && size_of(mode) < kTiny * size_of(other);
  });
}

}  // namespace

std::vector<Eigen::VectorXcd> refine_without_satellites(const FrfDataset& set, std::vector<FittedMode>& modes) {
  std::vector<FittedMode> fewer;
  std::copy_if(modes.begin(), modes.end(), std::back_inserter(fewer),
               [&](const FittedMode& mode) { return !is_satellite(mode, modes); });
  if (fewer.size() == modes.size()) return {};
  std::vector<Eigen::VectorXcd> residual = refine_jointly(set, fewer);
  const bool as_good = std::all_of(fewer.begin(), fewer.end(), [](const FittedMode& mode) { return mode.joint; });
  if (residual.empty() || !as_good) return {};
  modes = std::move(fewer);
  return residual;
}

}  // namespace percuss::identify
