#include "pipeline/stages/tone_modes.hpp"

#include <algorithm>
#include <cmath>

#include "identify/hits/residue_coherence.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kMaxLines = 2;       // half-power bandwidth of a remainder, in line spacings: wandering broadens it
constexpr double kMaxOff = 4e-4;      // error of a tone's frequency, relative
constexpr double kWanderReach = 0.1;  // of the frequency of a tone that wanders, as in refit_modes_near_tones()

bool is_harmonic_of_mains(double freq_Hz, const Tone& tone, double reach_Hz) {
  const double order = std::round(freq_Hz / tone.freq_Hz);
  return may_be_mains(tone.freq_Hz) && order >= 1 && std::abs(freq_Hz - order * tone.freq_Hz) < reach_Hz;
}

bool is_at_a_tone(double freq_Hz, const std::vector<Tone>& tones, double df_Hz) {
  return std::any_of(tones.begin(), tones.end(), [&](const Tone& tone) {
    const double reach_Hz = df_Hz + kMaxOff * freq_Hz;
    const double of_tone_Hz = tone.wanders ? kWanderReach * tone.freq_Hz : reach_Hz;
    return std::abs(freq_Hz - tone.freq_Hz) < of_tone_Hz || is_harmonic_of_mains(freq_Hz, tone, reach_Hz);
  });
}

}  // namespace

void remove_tone_modes(std::vector<identify::Mode>& modes, const std::vector<Tone>& tones,
                       const identify::FrfDataset& set, const std::function<const identify::HitFrfs&()>& hits) {
  const double df_Hz = set.lines.df_Hz();
  const auto may_be_remainder = [&](const identify::Mode& mode) {
    return mode.pole.half_power_Hz() <= kMaxLines * df_Hz && is_at_a_tone(mode.pole.freq_Hz, tones, df_Hz);
  };
  if (std::none_of(modes.begin(), modes.end(), may_be_remainder)) return;
  std::vector<bool> remainder(modes.size());
  for (const identify::ModeWindow& window : identify::mode_windows(set, modes)) {
    for (std::size_t i = 0; i < window.modes.size(); ++i) {
      if (!may_be_remainder(modes[window.modes[i]])) continue;
      const auto points = identify::residue_coherence(set, hits(), modes, window, i);
      remainder[window.modes[i]] =
          std::none_of(points.begin(), points.end(), [](const identify::ResidueCoherence& point) {
            return identify::residues_of_equal_size_agree(point).value_or(true);
          });
    }
  }
  std::size_t m = 0;
  std::erase_if(modes, [&](const identify::Mode&) { return remainder[m++]; });
}

}  // namespace percuss::pipeline
