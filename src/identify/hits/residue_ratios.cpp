#include "identify/hits/residue_ratios.hpp"

#include <algorithm>

namespace percuss::identify {

std::vector<ResidueRatio> residue_ratios(const HitFrfs& hits, const ProjectedState& state, const Mode& mode,
                                         const std::vector<std::size_t>& residue_of, Eigen::Index at, double freedom) {
  std::vector<ResidueRatio> ratios(hits.points.size());
  for (const ProjectedPart& part : state.parts) {
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const std::size_t o = part.channels[i];
      const auto column = static_cast<Eigen::Index>(i);
      const double noise2 = std::max(part.residual.col(column).squaredNorm() / freedom, 1e-300);
      const Complex expected = mode.residues[residue_of[o]].value;
      const double scale = 2 / (noise2 * part.inverse_gram(at, at).real());  // the real part has half the variance
      ResidueRatio& ratio = ratios[hits.set.channels[o].point];
      ratio.sum += scale * (std::conj(expected) * part.amplitude(at, column)).real();
      ratio.weight += scale * std::norm(expected);
    }
  }
  return ratios;
}

}  // namespace percuss::identify
