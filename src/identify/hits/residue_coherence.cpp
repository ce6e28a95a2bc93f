#include "identify/hits/residue_coherence.hpp"

#include <algorithm>

#include "identify/fit/local_fit.hpp"
#include "identify/fit/variable_projection.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// A mode's residues in one hit, relative to its residues in the test.
struct HitRatio {
  Complex sum;
  double weight = 0;
};

// [hits]
std::vector<HitRatio> hit_ratios(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes,
                                 const ModeWindow& window, std::size_t mode) {
  const std::size_t terms = LocalFitOptions{}.residual_terms;
  const auto data = hit_data(set, hits, modes, window);
  const VectorXd ones = VectorXd::Ones(static_cast<Index>(data.size()));
  const VariableProjection projection(hits.set, data, ones, window.first, window.count, terms);
  const ProjectedState state = projection.evaluate(window.poles(modes));
  const std::vector<std::size_t> residue_of = residue_indices(set, hits);
  const auto at = static_cast<Index>(mode);
  std::vector<HitRatio> ratios(hits.points.size());
  for (const ProjectedPart& part : state.parts) {
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const std::size_t o = part.channels[i];
      const auto column = static_cast<Index>(i);
      const double variance =
          std::max(part.residual.col(column).squaredNorm() * part.inverse_gram(at, at).real(), 1e-300);
      const Complex expected = modes[window.modes[mode]].residues[residue_of[o]].value;
      HitRatio& ratio = ratios[hits.set.channels[o].point];
      ratio.sum += std::conj(expected) * part.amplitude(at, column) / variance;
      ratio.weight += std::norm(expected) / variance;
    }
  }
  return ratios;
}

}  // namespace

std::vector<ResidueCoherence> residue_coherence(const FrfDataset& set, const HitFrfs& hits,
                                                const std::vector<Mode>& modes, const ModeWindow& window,
                                                std::size_t mode) {
  const std::vector<HitRatio> ratios = hit_ratios(set, hits, modes, window, mode);
  std::vector<ResidueCoherence> out(set.points.size());
  std::vector<Complex> sum(out.size());
  std::vector<double> weight(out.size()), power(out.size());
  for (std::size_t h = 0; h < ratios.size(); ++h) {
    if (!(ratios[h].weight > 0)) continue;
    const std::size_t point = hits.points[h];
    sum[point] += ratios[h].sum;
    weight[point] += ratios[h].weight;
    power[point] += std::norm(ratios[h].sum) / ratios[h].weight;
    ++out[point].hits;
  }
  for (std::size_t p = 0; p < out.size(); ++p)
    out[p].coherence = power[p] > 0 ? std::norm(sum[p]) / (weight[p] * power[p]) : 0;
  return out;
}

}  // namespace percuss::identify
