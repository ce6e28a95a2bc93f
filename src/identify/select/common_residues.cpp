#include "identify/select/common_residues.hpp"

#include <algorithm>
#include <cmath>

#include "identify/fit/joint_fit.hpp"
#include "identify/model/frf_synthesis.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;

constexpr double kVisible = 0.02;  // residual energy over an FRF's energy: a FRAC of 0.98
constexpr double kWorse = 4;       // residual energy of the sum over the common fit's: twice the amplitude

// [channels] residual energy over the FRF's energy.
std::vector<double> shares_of(const FrfDataset& set, const std::vector<VectorXcd>& residual) {
  std::vector<double> shares;
  for (std::size_t o = 0; o < residual.size(); ++o) {
    const Eigen::Map<const VectorXcd> frf(set.channels[o].frf.data(), residual[o].size());
    const double energy = frf.squaredNorm();
    shares.push_back(energy > 0 ? residual[o].squaredNorm() / energy : 0);
  }
  return shares;
}

// The residual where each mode keeps its own residues.
std::vector<VectorXcd> residual_of_sum(const FrfDataset& set, const std::vector<FittedMode>& modes) {
  std::vector<Mode> own;
  own.reserve(modes.size());
  for (const FittedMode& mode : modes) own.push_back(mode.mode);
  return residuals_from_sums(set, modal_sums(set, own));
}

}  // namespace

void fit_common_residues(const FrfDataset& set, std::vector<FittedMode>& modes) {
  const bool local = std::any_of(modes.begin(), modes.end(), [](const FittedMode& mode) { return !mode.joint; });
  if (modes.size() < 2 || !local) return;
  const std::vector<double> apart = shares_of(set, residual_of_sum(set, modes));
  if (*std::max_element(apart.begin(), apart.end()) < kVisible) return;
  const JointFit fit = fit_residues(set, poles_of(modes));
  const std::vector<double> together = shares_of(set, fit.residual);
  bool worse = false;
  for (std::size_t o = 0; o < apart.size(); ++o)
    worse = worse || (apart[o] > kVisible && apart[o] > kWorse * together[o]);
  if (!worse) return;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    for (std::size_t o = 0; o < set.channels.size(); ++o) {
      Residue& residue = modes[m].mode.residues[o];
      residue.value = fit.residues(static_cast<Index>(o), static_cast<Index>(m));
      residue.std = std::max(residue.std, fit.residue_std(static_cast<Index>(o), static_cast<Index>(m)));
      residue.own_pole.reset();
    }
  }
}

}  // namespace percuss::identify
