#include "pipeline/stages/fit_quality.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "identify/model/frf_synthesis.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kPeakRange_dB = 65;  // below the largest line; lower peaks are not reported
constexpr double kModeWidths = 3;     // half-power bandwidths on either side of a mode
constexpr double kMinModeLines = 5;   // on either side

// FRAC of all FRFs together over the lines around a mode.
double frac_around(const identify::FrfDataset& set, const std::vector<identify::SynthesisedFrf>& made,
                   const acquire::LineRange& band, const identify::Pole& pole) {
  const double at = band.position(pole.freq_Hz);
  const double reach = std::max(kModeWidths * pole.half_power_Hz() / band.df_Hz(), kMinModeLines);
  const std::size_t from = band.at(at - reach), to = band.at(at + reach), skip = band.first - set.lines.first;
  std::vector<Complex> measured, synthesised;
  for (std::size_t o = 0; o < set.channels.size(); ++o) {
    for (std::size_t k = from; k <= to; ++k) {
      measured.push_back(set.channels[o].frf[skip + k]);
      synthesised.push_back(made[o].value[k]);
    }
  }
  return identify::frac(measured, synthesised);
}

}  // namespace

std::vector<identify::UnmodelledPeak> unexplained_peaks_of(const identify::FrfDataset& set,
                                                           const std::vector<identify::Mode>& modes,
                                                           const std::vector<identify::Mode>& beyond) {
  auto peaks = identify::clear_of_noise(set, identify::unmodelled_peaks(set, modes, kPeakRange_dB, beyond));
  std::stable_sort(peaks.begin(), peaks.end(), [](const auto& a, const auto& b) { return a.level_dB > b.level_dB; });
  return peaks;
}

FitQuality fit_quality(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes,
                       const std::vector<identify::SynthesisedFrf>& made, const acquire::LineRange& band) {
  FitQuality out;
  if (band.count == 0) return out;
  const double end = kTwoPi * band.freq_Hz(band.count - 1);  // to which the terms are normalised
  for (const identify::SynthesisedFrf& frf : made) {
    out.frfs.push_back({.point = frf.point,
                        .channel = frf.channel,
                        .frac = frf.frac,
                        .lower = frf.terms[0],
                        .upper = frf.terms[1] / (end * end),
                        .upper4 = frf.terms[2] / std::pow(end, 4),
                        .upper6 = frf.terms[3] / std::pow(end, 6)});
  }
  for (const identify::Mode& mode : modes) out.mode_frac.push_back(frac_around(set, made, band, mode.pole));
  return out;
}

}  // namespace percuss::pipeline
