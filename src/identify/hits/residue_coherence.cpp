#include "identify/hits/residue_coherence.hpp"

#include <algorithm>
#include <cmath>

#include "identify/fit/local_fit.hpp"
#include "identify/fit/variable_projection.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// A mode's residues r at one FRF in all hits, with the weights w.
struct ResidueSums {
  Complex sum;                               // Σ w r
  double weight = 0, square = 0, power = 0;  // Σ w, Σ w², Σ w |r|²
};

// [channels of set]
std::vector<ResidueSums> residue_sums(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes,
                                      const ModeWindow& window, std::size_t mode) {
  const std::size_t terms = LocalFitOptions{}.residual_terms;
  const auto data = hit_data(set, hits, modes, window);
  const VectorXd ones = VectorXd::Ones(static_cast<Index>(data.size()));
  const VariableProjection projection(hits.set, data, ones, window.first, window.count, terms);
  const ProjectedState state = projection.evaluate(window.poles(modes));
  const std::vector<std::size_t> residue_of = residue_indices(set, hits);
  const auto at = static_cast<Index>(mode);
  std::vector<ResidueSums> sums(set.channels.size());
  for (const ProjectedPart& part : state.parts) {
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const auto column = static_cast<Index>(i);
      const double variance =
          std::max(part.residual.col(column).squaredNorm() * part.inverse_gram(at, at).real(), 1e-300);
      const Complex residue = part.amplitude(at, column);
      ResidueSums& of_frf = sums[residue_of[part.channels[i]]];
      of_frf.sum += residue / variance;
      of_frf.weight += 1 / variance;
      of_frf.square += 1 / (variance * variance);
      of_frf.power += std::norm(residue) / variance;
    }
  }
  return sums;
}

// Whether the coherence is too high for independent residues of this number of hits. The coherence of n independent
// circular normal residues exceeds c with the probability (1 − c)^(n − 1). Residues of equal size and independent
// phases exceed this limit more often: with three hits once in 80 times.
std::optional<bool> agree(const ResidueCoherence& point, double hits) {
  constexpr double kChance = 1e-3;
  constexpr std::size_t kPhaseHits = 3;
  if (point.hits < kPhaseHits) return std::nullopt;
  return hits > 1 && point.coherence > 1 - std::pow(kChance, 1 / (hits - 1));
}

}  // namespace

std::optional<bool> residues_agree(const ResidueCoherence& point) {
  return agree(point, static_cast<double>(point.hits));
}

std::optional<bool> residues_of_equal_size_agree(const ResidueCoherence& point) {
  return agree(point, point.effective_hits);
}

std::vector<ResidueCoherence> residue_coherence(const FrfDataset& set, const HitFrfs& hits,
                                                const std::vector<Mode>& modes, const ModeWindow& window,
                                                std::size_t mode) {
  std::vector<ResidueCoherence> out(set.points.size());
  for (const std::size_t point : hits.points) ++out[point].hits;
  std::vector<double> common(out.size()), power(out.size());
  const std::vector<ResidueSums> sums = residue_sums(set, hits, modes, window, mode);
  for (std::size_t o = 0; o < sums.size(); ++o) {
    if (!(sums[o].weight > 0)) continue;
    common[set.channels[o].point] += std::norm(sums[o].sum) / sums[o].weight;
    power[set.channels[o].point] += sums[o].power;
    double& effective = out[set.channels[o].point].effective_hits;
    effective = std::max(effective, sums[o].weight * sums[o].weight / sums[o].square);
  }
  for (std::size_t p = 0; p < out.size(); ++p) out[p].coherence = power[p] > 0 ? common[p] / power[p] : 0;
  return out;
}

std::vector<std::optional<bool>> residues_agree_between_hits(const FrfDataset& set, const HitFrfs& hits,
                                                             const std::vector<Mode>& modes) {
  constexpr double kAgreement = 0.9;  // of two hits; equal sizes of independent phases exceed it once in five times
  std::vector<std::optional<bool>> agree(modes.size());
  for (const ModeWindow& window : mode_windows(set, modes)) {
    for (std::size_t i = 0; i < window.modes.size(); ++i) {
      std::optional<bool>& of_mode = agree[window.modes[i]];
      for (const ResidueCoherence& point : residue_coherence(set, hits, modes, window, i)) {
        std::optional<bool> at_point = residues_agree(point);
        if (point.hits == 2 && point.coherence < kAgreement) at_point = false;
        if (at_point) of_mode = of_mode.value_or(false) || *at_point;
      }
    }
  }
  return agree;
}

}  // namespace percuss::identify
