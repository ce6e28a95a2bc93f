#include "pipeline/stages/mains_modes.hpp"

#include <algorithm>
#include <cmath>

#include "identify/hits/residue_coherence.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kMaxOff = 4e-4;  // error of the fundamental, as part of its frequency

bool is_harmonic(double freq_Hz, const std::vector<Tone>& tones, double df_Hz) {
  return std::any_of(tones.begin(), tones.end(), [&](const Tone& tone) {
    if (!may_be_mains(tone.freq_Hz)) return false;
    const double order = std::round(freq_Hz / tone.freq_Hz);
    return order >= 1 && std::abs(freq_Hz - order * tone.freq_Hz) < df_Hz + kMaxOff * freq_Hz;
  });
}

}  // namespace

void remove_mains_modes(std::vector<identify::Mode>& modes, const std::vector<Tone>& tones,
                        const identify::FrfDataset& set, const identify::HitFrfs& hits) {
  const double df_Hz = set.lines.df_Hz();
  const auto may_be_hum = [&](const identify::Mode& mode) {
    return mode.pole.half_power_Hz() <= df_Hz && is_harmonic(mode.pole.freq_Hz, tones, df_Hz);
  };
  if (std::none_of(modes.begin(), modes.end(), may_be_hum)) return;
  std::vector<bool> hum(modes.size());
  for (const identify::ModeWindow& window : identify::mode_windows(set, modes)) {
    for (std::size_t i = 0; i < window.modes.size(); ++i) {
      if (!may_be_hum(modes[window.modes[i]])) continue;
      const auto points = identify::residue_coherence(set, hits, modes, window, i);
      hum[window.modes[i]] = std::none_of(points.begin(), points.end(), [](const identify::ResidueCoherence& point) {
        return identify::residues_agree(point).value_or(true);
      });
    }
  }
  std::size_t m = 0;
  std::erase_if(modes, [&](const identify::Mode&) { return hum[m++]; });
}

}  // namespace percuss::pipeline
