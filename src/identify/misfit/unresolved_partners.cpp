#include "identify/misfit/unresolved_partners.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "identify/misfit/misfit.hpp"
#include "identify/model/close_poles.hpp"

namespace percuss::identify {
namespace {

constexpr double kUnresolvedDamping = 0.5;  // relative standard deviation of a partner's damping

double relative_damping_std(const Mode& mode) { return mode.damping_std / mode.pole.damping_ratio; }

// All poles except the unresolved ones. A pole is unresolved if the relative standard deviation of its damping, misfit
// included, is above kUnresolvedDamping, and a close pole (are_close) has a smaller one.
std::vector<Pole> resolved_poles(const FrfDataset& set, const std::vector<FittedMode>& found) {
  std::vector<Mode> modes;
  for (const FittedMode& mode : found) {
    modes.push_back(mode.mode);
    modes.back().freq_std_parts_Hz = {.noise = mode.mode.freq_std_Hz};
    modes.back().damping_std_parts = {.noise = mode.mode.damping_std};
  }
  add_misfit(set, modes);
  std::vector<Pole> kept;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const double own = relative_damping_std(modes[m]);
    const auto is_clearer_partner = [&](const Mode& other) {
      return &other != &modes[m] && are_close(other.pole, modes[m].pole) && relative_damping_std(other) < own;
    };
    const bool unresolved = own > kUnresolvedDamping && std::any_of(modes.begin(), modes.end(), is_clearer_partner);
    if (!unresolved) kept.push_back(modes[m].pole);
  }
  return kept;
}

bool any_pair(const std::vector<FittedMode>& found) {
  for (std::size_t m = 1; m < found.size(); ++m)
    if (are_close(found[m - 1].mode.pole, found[m].mode.pole)) return true;
  return false;
}

}  // namespace

std::vector<FittedMode> without_unresolved_partners(const FrfDataset& set, std::vector<FittedMode> found,
                                                    const SequentialFitOptions& options) {
  while (any_pair(found)) {
    SequentialFitOptions again = options;
    again.start = resolved_poles(set, found);
    if (again.start.size() == found.size()) break;
    found = fit_sequentially(set, again);
  }
  return found;
}

}  // namespace percuss::identify
