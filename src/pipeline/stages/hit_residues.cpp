#include "pipeline/stages/hit_residues.hpp"

#include <utility>

#include "identify/hits/hit_scatter.hpp"
#include "identify/noise/force_noise.hpp"

namespace percuss::pipeline {

std::vector<std::vector<ModeInHit>> modes_in_hits(const identify::FrfDataset& set, const identify::HitFrfs& hits,
                                                  const std::vector<identify::Mode>& modes) {
  const identify::WindowedHitPoles linear = identify::windowed_hit_poles(set, hits, modes);
  std::vector<std::vector<ModeInHit>> out(linear.poles.size());
  for (std::size_t m = 0; m < out.size(); ++m) {
    const double freq_Hz = modes[m].pole.freq_Hz;
    const std::size_t line = set.lines.nearest(freq_Hz);
    for (std::size_t h = 0; h < hits.points.size(); ++h) {
      const identify::HitPole& pole = linear.poles[m].hits[h];
      if (!(pole.residue_ratio.weight > 0)) continue;
      out[m].push_back({.point = hits.points[h],
                        .hit = h,
                        .power = hits.set.points[h].ff[line],
                        .relative_std = identify::gain_amplitude_std(hits.set, h, freq_Hz),
                        .residues = pole.residues});
    }
  }
  return out;
}

}  // namespace percuss::pipeline
