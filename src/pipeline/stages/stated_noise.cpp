#include "pipeline/stages/stated_noise.hpp"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "identify/model/frf_synthesis.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kNoiseReach = 2;            // half-power bandwidths on each side of a mode
constexpr std::size_t kMinNoiseReach = 100;  // lines on each side, over which the joint fit takes the noise
constexpr double kMinVariance = 1e-300;

struct NoiseWindow {
  std::size_t first = 0, end = 0;  // lines
};

NoiseWindow noise_window_around(const identify::Mode& mode, const acquire::LineRange& lines) {
  const std::size_t middle = lines.nearest(mode.pole.freq_Hz);
  const auto reach = std::max(
      kMinNoiseReach, static_cast<std::size_t>(std::ceil(kNoiseReach * mode.pole.half_power_Hz() / lines.df_Hz())));
  return {.first = middle - std::min(middle, reach), .end = std::min(lines.count, middle + reach + 1)};
}

// [lines of the window] how much the noise of each line moves the pole: |∂H/∂λ|², without the part of ∂H/∂λ that the
// residue and a constant absorb. The sum is 1.
Eigen::VectorXd influence_of_lines(const identify::Pole& pole, const acquire::LineRange& lines, double decay_per_s,
                                   const NoiseWindow& window) {
  const double omega = kTwoPi * pole.freq_Hz;
  const Complex lambda = omega * Complex(-pole.damping_ratio, std::sqrt(1 - pole.damping_ratio * pole.damping_ratio));
  const auto count = static_cast<Eigen::Index>(window.end - window.first);
  Eigen::MatrixXcd absorbed(count, 2);
  Eigen::VectorXcd change(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Complex s(decay_per_s, kTwoPi * lines.freq_Hz(window.first + static_cast<std::size_t>(k)));
    const Complex column = s * s / ((s - lambda) * omega);
    absorbed(k, 0) = column;
    absorbed(k, 1) = 1;
    change(k) = column * omega / (s - lambda);
  }
  change -= absorbed * absorbed.colPivHouseholderQr().solve(change);
  const Eigen::VectorXd influence = change.cwiseAbs2();
  return influence / std::max(influence.sum(), kMinVariance);
}

// The stated variance of the lines that move the pole; 0 where none is stated.
double stated_variance(const std::vector<double>& std, std::size_t offset, const NoiseWindow& window,
                       const Eigen::VectorXd& influence) {
  double sum = 0;
  for (std::size_t k = window.first; k < window.end && !std.empty(); ++k)
    sum += influence(static_cast<Eigen::Index>(k - window.first)) * std[offset + k] * std[offset + k];
  return sum;
}

// The mean square of the residual, from which the fit takes the noise.
double residual_variance(const std::vector<Complex>& frf, const std::vector<Complex>& fit, const NoiseWindow& window) {
  double sum = 0;
  for (std::size_t k = window.first; k < window.end; ++k) sum += std::norm(frf[k] - fit[k]);
  return std::max(kMinVariance, sum / static_cast<double>(window.end - window.first));
}

}  // namespace

void widen_to_stated_noise(const acquire::FrfRecord& given, const identify::FrfDataset& set,
                           std::vector<identify::Mode>& modes) {
  const auto states_none = [](const acquire::PointFrf& one) { return one.frf.std.empty(); };
  if (std::all_of(given.frfs.begin(), given.frfs.end(), states_none)) return;
  const std::vector<identify::SynthesisedFrf> fits = identify::synthesised_frfs(set, modes, set.lines);
  const std::size_t offset = set.lines.first - given.lines.first;
  for (identify::Mode& mode : modes) {
    const NoiseWindow window = noise_window_around(mode, set.lines);
    const Eigen::VectorXd influence = influence_of_lines(mode.pole, set.lines, set.window_decay_per_s(), window);
    // The weights of the FRFs in the fit come from the residual. They stay, whatever is stated.
    double weights = 0, variance_of_pole = 0;
    for (std::size_t o = 0; o < mode.residues.size(); ++o) {
      identify::Residue& residue = mode.residues[o];
      const double fitted = residual_variance(set.channels[o].frf, fits[o].value, window);
      const double variance = std::max(fitted, stated_variance(given.frfs[o].frf.std, offset, window, influence));
      const double weight = std::norm(residue.value) / fitted;
      weights += weight;
      variance_of_pole += weight * variance / fitted;
      residue.std *= std::sqrt(variance / fitted);
    }
    if (!(weights > 0)) continue;
    const double ratio = std::sqrt(variance_of_pole / weights);
    if (!(ratio > 1)) continue;
    mode.freq_std_parts_Hz.noise *= ratio;
    mode.damping_std_parts.noise *= ratio;
    mode.freq_std_Hz = mode.freq_std_parts_Hz.total();
    mode.damping_std = mode.damping_std_parts.total();
  }
}

}  // namespace percuss::pipeline
