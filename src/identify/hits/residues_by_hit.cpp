#include "identify/hits/residues_by_hit.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/significance.hpp"
#include "identify/fit/local_fit.hpp"
#include "identify/fit/variable_projection.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kBroader = 1.3;     // damping ratio over the stronger mode's
constexpr double kWeaker = 0.5;      // peak over the stronger mode's
constexpr double kDisagreement = 5;  // standard deviations between the best hit and the others
constexpr double kMinShare = 0.6;  // of the residue: a gain or a direction that varies changes it less

double peak_of(const Mode& mode) {
  double power = 0;
  for (const Residue& residue : mode.residues) power += std::norm(residue.value);
  return std::sqrt(power) / mode.pole.damping_ratio;
}

// Whether a stronger and narrower mode of the window overlaps this mode.
bool is_under_another(const std::vector<Mode>& modes, const ModeWindow& window, std::size_t mode) {
  const Pole& pole = modes[mode].pole;
  return std::any_of(window.modes.begin(), window.modes.end(), [&](std::size_t other) {
    const Pole& strong = modes[other].pole;
    return other != mode && pole.damping_ratio > kBroader * strong.damping_ratio &&
           peak_of(modes[mode]) < kWeaker * peak_of(modes[other]) &&
           std::abs(pole.freq_Hz - strong.freq_Hz) < 0.5 * (pole.half_power_Hz() + strong.half_power_Hz());
  });
}

// A mode's residue in one hit over its residue in the test, and the weight of that ratio, one over its variance.
struct ResidueRatio {
  double sum = 0, weight = 0;
  double value() const { return sum / weight; }
};

std::vector<ResidueRatio> residue_ratios(const HitFrfs& hits, const ProjectedState& state, const Mode& mode,
                                         const std::vector<std::size_t>& residue_of, Index at, double freedom) {
  std::vector<ResidueRatio> ratios(hits.points.size());
  for (const ProjectedPart& part : state.parts) {
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const std::size_t o = part.channels[i];
      const auto column = static_cast<Index>(i);
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

// Whether two modes of the window overlap.
bool any_overlap(const std::vector<Pole>& poles) {
  for (std::size_t i = 0; i < poles.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (std::abs(poles[i].freq_Hz - poles[k].freq_Hz) < std::max(poles[i].half_power_Hz(), poles[k].half_power_Hz()))
        return true;
    }
  }
  return false;
}

bool scatter(const std::vector<ResidueRatio>& ratios) {
  ResidueRatio all;
  double chi2 = 0, degrees = -1;
  for (const ResidueRatio& one : ratios) {
    all.sum += one.sum;
    all.weight += one.weight;
  }
  for (const ResidueRatio& one : ratios) {
    if (!(one.weight > 0)) continue;
    chi2 += one.weight * std::pow(one.value() - all.value(), 2);
    ++degrees;
  }
  return degrees > 0 && chi2_deviate(chi2, degrees) > kDisagreement;
}

// The fit of the single hits over a window, at the modes' poles.
class HitResidues {
 public:
  HitResidues(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes, const ModeWindow& window)
      : hits_(hits), modes_(modes), window_(window), residue_of_(residue_indices(set, hits)) {
    const std::vector<Pole> poles = window.poles(modes);
    const auto data = hit_data(set, hits, modes, window);
    const std::size_t terms = LocalFitOptions{}.residual_terms;
    freedom_ = std::max(1.0, static_cast<double>(window.count) - static_cast<double>(poles.size() + terms));
    const VectorXd ones = VectorXd::Ones(static_cast<Index>(data.size()));
    state_ = VariableProjection(hits.set, data, ones, window.first, window.count, terms).evaluate(poles);
  }
  std::vector<ResidueRatio> ratios(std::size_t i) const {
    return residue_ratios(hits_, state_, modes_[window_.modes[i]], residue_of_, static_cast<Index>(i), freedom_);
  }

 private:
  const HitFrfs& hits_;
  const std::vector<Mode>& modes_;
  const ModeWindow& window_;
  std::vector<std::size_t> residue_of_;
  ProjectedState state_;
  double freedom_ = 1;
};

bool disagree(const std::vector<ResidueRatio>& ratios) {
  const auto best =
      std::max_element(ratios.begin(), ratios.end(), [](const auto& a, const auto& b) { return a.weight < b.weight; });
  ResidueRatio rest;
  for (auto one = ratios.begin(); one != ratios.end(); ++one) {
    if (one == best) continue;
    rest.sum += one->sum;
    rest.weight += one->weight;
  }
  if (!(rest.weight > 0 && best->weight > 0)) return false;
  const double a = best->value(), b = rest.value();
  return std::abs(a - b) > kDisagreement * std::sqrt(1 / best->weight + 1 / rest.weight) &&
         std::min(a, b) < kMinShare * std::max(a, b);
}

}  // namespace

std::vector<std::size_t> modes_of_some_hits(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes,
                                            const ModeWindow& window) {
  std::vector<std::size_t> some;
  if (std::none_of(window.modes.begin(), window.modes.end(),
                   [&](std::size_t m) { return is_under_another(modes, window, m); }))
    return some;
  const HitResidues residues(set, hits, modes, window);
  for (std::size_t i = 0; i < window.modes.size(); ++i) {
    const std::size_t m = window.modes[i];
    if (is_under_another(modes, window, m) && disagree(residues.ratios(i))) some.push_back(m);
  }
  return some;
}

bool residues_of_pair_scatter(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes,
                              const ModeWindow& window) {
  if (!any_overlap(window.poles(modes))) return false;
  const HitResidues residues(set, hits, modes, window);
  for (std::size_t i = 0; i < window.modes.size(); ++i) {
    if (scatter(residues.ratios(i))) return true;
  }
  return false;
}

}  // namespace percuss::identify
