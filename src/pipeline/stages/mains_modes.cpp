#include "pipeline/stages/mains_modes.hpp"

#include <algorithm>
#include <cmath>

namespace percuss::pipeline {
namespace {

constexpr double kChance = 1e-3;         // that independent phases give a higher coherence
constexpr double kMaxOff = 4e-4;         // error of the fundamental, as part of its frequency
constexpr std::size_t kMinAverages = 3;  // fewer hits do not show whether the phases are independent

// Whether the motion at a line follows the force. The coherence of n hits with independent phases exceeds c with the
// probability (1 − c)^(n − 1).
bool follows_force(const acquire::Frf& frf, std::size_t line) {
  if (frf.averages < kMinAverages || line >= frf.coherence.size()) return true;
  return frf.coherence[line] > 1 - std::pow(kChance, 1 / static_cast<double>(frf.averages - 1));
}

bool is_harmonic(double freq_Hz, const std::vector<Tone>& tones, double line_Hz) {
  return std::any_of(tones.begin(), tones.end(), [&](const Tone& tone) {
    if (!may_be_mains(tone.freq_Hz)) return false;
    const double order = std::round(freq_Hz / tone.freq_Hz);
    return order >= 1 && std::abs(freq_Hz - order * tone.freq_Hz) < line_Hz + kMaxOff * freq_Hz;
  });
}

}  // namespace

void remove_mains_modes(std::vector<identify::Mode>& modes, const std::vector<Tone>& tones,
                        const acquire::LineRange& lines, const std::vector<acquire::PointFrf>& frfs) {
  std::erase_if(modes, [&](const identify::Mode& mode) {
    const double freq_Hz = mode.pole.freq_Hz;
    if (mode.pole.half_power_Hz() > lines.df_Hz() || !is_harmonic(freq_Hz, tones, lines.df_Hz())) return false;
    return std::none_of(frfs.begin(), frfs.end(),
                        [&](const acquire::PointFrf& one) { return follows_force(one.frf, lines.nearest(freq_Hz)); });
  });
}

}  // namespace percuss::pipeline
