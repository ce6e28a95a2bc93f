#include "identify/hits/nonlinearity_modes.hpp"

#include <algorithm>
#include <cmath>

#include "identify/fit/local_fit.hpp"
#include "identify/fit/variable_projection.hpp"
#include "identify/hits/residue_ratios.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kBroader = 1.3;     // damping ratio over the stronger mode's
constexpr double kWeaker = 0.5;      // peak over the stronger mode's
constexpr double kDisagreement = 5;  // standard deviations of the best hit from the others
constexpr double kMinShare = 0.6;    // smaller over larger residue: varying gains or directions keep it above this

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

// Whether the hit with the most precise ratio contradicts the mean of the other hits.
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

std::vector<std::size_t> spurious_modes_of_nonlinearity(const FrfDataset& set, const HitFrfs& hits,
                                                        const std::vector<Mode>& modes, const ModeWindow& window,
                                                        const std::vector<Mode>& modes_in_hits) {
  std::vector<std::size_t> spurious;
  if (std::none_of(window.modes.begin(), window.modes.end(),
                   [&](std::size_t m) { return is_under_another(modes, window, m); }))
    return spurious;
  const auto data = hit_data(set, hits, modes, window, modes_in_hits);
  const std::size_t terms = LocalFitOptions{}.residual_terms;
  const double freedom =
      std::max(1.0, static_cast<double>(window.count) - static_cast<double>(window.modes.size() + terms));
  const ProjectedState state = VariableProjection(hits.set, data, VectorXd::Ones(static_cast<Index>(data.size())),
                                                  window.first, window.count, terms)
                                   .evaluate(window.poles(modes));
  const HitResidues residues(set, hits, modes, window, state, freedom);
  for (std::size_t i = 0; i < window.modes.size(); ++i) {
    const std::size_t m = window.modes[i];
    if (is_under_another(modes, window, m) && disagree(residues.ratios(i))) spurious.push_back(m);
  }
  return spurious;
}

}  // namespace percuss::identify
