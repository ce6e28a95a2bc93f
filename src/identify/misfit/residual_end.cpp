#include "identify/misfit/residual_end.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>

#include "identify/model/frf_synthesis.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr double kRoughness = 1.5;  // variance of half the second difference of white noise, over the noise's own
constexpr std::size_t kMinLines = 100;
constexpr Index kBlocks = 24;     // of the lines
constexpr double kMinEnergy = 4;  // of a residual over its noise: twice the amplitude
// The energy at the end over the energy anywhere else. Where a smooth residual has another cause, it rises by less.
constexpr double kMinEnergyRatio = 1.5;

// [blocks] energy of the residual over the energy of its noise, mean over the FRFs. The second difference from line to
// line shows the noise.
VectorXd block_energies(const std::vector<VectorXcd>& residual) {
  VectorXd energies = VectorXd::Zero(kBlocks);
  for (const VectorXcd& of_frf : residual) {
    const Index inner = of_frf.size() - 2;
    const VectorXcd rough = of_frf.segment(1, inner) - 0.5 * (of_frf.head(inner) + of_frf.tail(inner));
    for (Index b = 0; b < kBlocks; ++b) {
      const Index from = b * inner / kBlocks, count = (b + 1) * inner / kBlocks - from;
      const double noise = rough.segment(from, count).squaredNorm() / kRoughness;
      if (noise > 0) energies(b) += of_frf.segment(from + 1, count).squaredNorm() / noise;
    }
  }
  return energies / static_cast<double>(residual.size());
}

}  // namespace

std::optional<double> growing_end_Hz(const FrfDataset& set, const std::vector<Mode>& modes, double misfit_Hz) {
  if (modes.empty() || set.lines.count < kMinLines) return std::nullopt;
  const VectorXd energies = block_energies(residuals_from_sums(set, modal_sums(set, modes)));
  const double others = energies.segment(1, kBlocks - 2).maxCoeff(), first = energies(0), last = energies(kBlocks - 1);
  const auto grows = [&](double energy, double other_end) {
    return energy > kMinEnergy && energy > kMinEnergyRatio * std::max(others, other_end);
  };
  const double first_Hz = set.lines.freq_Hz(0), last_Hz = set.lines.freq_Hz(set.lines.count - 1);
  const bool nearer_to_last = misfit_Hz * misfit_Hz > first_Hz * last_Hz;
  if (nearer_to_last && grows(last, first)) return last_Hz;
  if (!nearer_to_last && grows(first, last)) return first_Hz;
  return std::nullopt;
}

}  // namespace percuss::identify
