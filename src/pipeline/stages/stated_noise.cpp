#include "pipeline/stages/stated_noise.hpp"

#include <algorithm>
#include <cmath>

#include "identify/model/frf_synthesis.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kNoiseReach = 2;           // half-power bandwidths on each side of a mode
constexpr std::size_t kMinNoiseReach = 32;  // lines on each side: their mean square is known to 12 %
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

// The harmonic mean of the stated variance, since quiet lines tell most; 0 where none is stated.
double stated_variance(const std::vector<double>& std, std::size_t offset, const NoiseWindow& window) {
  double sum = 0;
  for (std::size_t k = window.first; k < window.end && !std.empty(); ++k)
    sum += 1 / std::max(kMinVariance, std[offset + k] * std[offset + k]);
  return sum > 0 ? static_cast<double>(window.end - window.first) / sum : 0;
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
    double by_fit = 0, by_stated = 0;  // information about the pole
    for (std::size_t o = 0; o < mode.residues.size(); ++o) {
      identify::Residue& residue = mode.residues[o];
      const double fitted = residual_variance(set.channels[o].frf, fits[o].value, window);
      const double variance = std::max(fitted, stated_variance(given.frfs[o].frf.std, offset, window));
      by_fit += std::norm(residue.value) / fitted;
      by_stated += std::norm(residue.value) / variance;
      residue.std *= std::sqrt(variance / fitted);
    }
    if (!(by_stated > 0)) continue;
    const double ratio = std::sqrt(by_fit / by_stated);
    if (!(ratio > 1)) continue;
    mode.freq_std_parts_Hz.noise *= ratio;
    mode.damping_std_parts.noise *= ratio;
    mode.freq_std_Hz = mode.freq_std_parts_Hz.total();
    mode.damping_std = mode.damping_std_parts.total();
  }
}

}  // namespace percuss::pipeline
