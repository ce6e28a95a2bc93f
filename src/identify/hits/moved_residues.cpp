#include "identify/hits/moved_residues.hpp"

#include <algorithm>

#include "identify/fit/local_fit.hpp"
#include "identify/fit/variable_projection.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;

// Moving the poles raises the energy of the residual. New residues are taken only if they leave at most this part of
// the rise. They remove half of it for a single mode, and nine tenths for two modes less than a bandwidth apart.
constexpr double kMaxLeft = 0.1;

// [modes, channels]
MatrixXcd residues_of(const ProjectedState& state, std::size_t channels) {
  MatrixXcd residues(state.parts.front().amplitude.rows(), static_cast<Index>(channels));
  for (const ProjectedPart& part : state.parts) {
    for (std::size_t i = 0; i < part.channels.size(); ++i)
      residues.col(static_cast<Index>(part.channels[i])) = part.amplitude.col(static_cast<Index>(i));
  }
  return residues;
}

// Energy that the columns of `state` leave with these residues.
double energy_left(const ProjectedState& state, const MatrixXcd& residues) {
  double energy = 0;
  for (const ProjectedPart& part : state.parts) {
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const auto column = static_cast<Index>(i);
      const Eigen::VectorXcd step = part.amplitude.col(column) - residues.col(static_cast<Index>(part.channels[i]));
      energy += (part.residual.col(column) + part.columns * step).squaredNorm();
    }
  }
  return energy;
}

bool is_real(const Mode& mode) {
  return std::all_of(mode.residues.begin(), mode.residues.end(),
                     [](const Residue& residue) { return residue.value.imag() == 0; });
}

bool has_own_poles(const Mode& mode) {
  return std::any_of(mode.residues.begin(), mode.residues.end(),
                     [](const Residue& residue) { return residue.own_pole.has_value(); });
}

}  // namespace

void move_residues(const FrfDataset& set, const ModeWindow& window, const std::vector<Pole>& before,
                   std::vector<Mode>& modes) {
  const std::vector<Pole> after = window.poles(modes);
  if (after.size() < 2 || after == before) return;
  const auto data = window_data(set, modes, window);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(static_cast<Index>(data.size()));
  const VariableProjection projection(set, data, ones, window.first, window.count, LocalFitOptions{}.residual_terms);
  const ProjectedState was = projection.evaluate(before), is = projection.evaluate(after);
  const MatrixXcd old = residues_of(was, data.size()), best = residues_of(is, data.size());
  const double unmoved = energy_left(was, old);
  if (energy_left(is, best) - unmoved > kMaxLeft * (energy_left(is, old) - unmoved)) return;
  for (std::size_t i = 0; i < after.size(); ++i) {
    Mode& mode = modes[window.modes[i]];
    if (has_own_poles(mode)) continue;
    const bool real = is_real(mode);
    for (std::size_t o = 0; o < data.size(); ++o) {
      const auto m = static_cast<Index>(i), channel = static_cast<Index>(o);
      const Complex step = best(m, channel) - old(m, channel);
      mode.residues[o].value += real ? Complex(step.real()) : step;
    }
  }
}

}  // namespace percuss::identify
