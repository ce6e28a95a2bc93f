#include "pipeline/stages/mains_modes.hpp"

#include <algorithm>
#include <cmath>

namespace percuss::pipeline {
namespace {

constexpr double kChance = 1e-3;      // that independent phases give a higher coherence
constexpr double kMaxOff = 4e-4;      // error of the fundamental, as part of its frequency
constexpr std::size_t kMinHits = 3;   // fewer do not show whether the phases are independent

// The largest coherence of any FRF at a line.
double coherence_at(const std::vector<acquire::PointFrf>& frfs, std::size_t line) {
  double most = 0;
  for (const acquire::PointFrf& one : frfs) {
    if (line < one.frf.coherence.size()) most = std::max(most, one.frf.coherence[line]);
  }
  return most;
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
                        const acquire::LineRange& lines, const std::vector<acquire::PointFrf>& frfs,
                        std::size_t hits) {
  if (hits < kMinHits) return;
  // For n independent phases, the coherence exceeds c with the probability (1 − c)^(n − 1).
  const double limit = 1 - std::pow(kChance, 1 / static_cast<double>(hits - 1));
  std::erase_if(modes, [&](const identify::Mode& mode) {
    return mode.pole.half_power_Hz() < lines.df_Hz() && is_harmonic(mode.pole.freq_Hz, tones, lines.df_Hz()) &&
           coherence_at(frfs, lines.nearest(mode.pole.freq_Hz)) < limit;
  });
}

}  // namespace percuss::pipeline
