#include "pipeline/stages/hit_scatter.hpp"

#include <algorithm>

#include "identify/hits/hit_scatter.hpp"
#include "identify/hits/residue_scatter.hpp"
#include "identify/started_modes.hpp"
#include "pipeline/stages/single_hits.hpp"

namespace percuss::pipeline {
namespace {

// Whether each of these modes has one of the kept frequencies.
bool all_are_kept(const std::vector<identify::Mode>& modes, const std::vector<double>& kept_Hz) {
  return std::all_of(modes.begin(), modes.end(), [&](const identify::Mode& mode) {
    return std::find(kept_Hz.begin(), kept_Hz.end(), mode.pole.freq_Hz) != kept_Hz.end();
  });
}

}  // namespace

void add_scatter_between_hits(const identify::FrfDataset& set, const TestSpectra& spectra,
                              const std::function<const identify::HitFrfs&()>& hits,
                              const identify::IdentifyOptions& options, const std::function<void()>& search,
                              std::vector<identify::Mode>& modes) {
  const std::vector<std::size_t> used = comparable_hits(spectra);
  if (used.size() < 2) return;
  const identify::HitFrfs& hit_frfs = hits();
  std::vector<double> peak_N;
  peak_N.reserve(used.size());
  for (const std::size_t h : used) peak_N.push_back(spectra.hits[h].hit.peak_N);
  identify::WindowedHitPoles linear = identify::windowed_hit_poles(set, hit_frfs, modes);
  if (!options.modes) {
    const auto kept_Hz = identify::without_imitating_modes(set, hit_frfs, linear, peak_N, modes);
    if (!kept_Hz.empty() && all_are_kept(identify::modes_at_starts(set.lines, modes, options.start_Hz), kept_Hz)) {
      modes = identify::modes_from_frequencies(set, kept_Hz, options.effort);
      search();
      linear = identify::windowed_hit_poles(set, hit_frfs, modes);
    }
  }
  identify::add_hit_scatter(set, hit_frfs, linear, peak_N, modes);
  identify::add_residue_scatter(set, hit_frfs, linear, modes);
}

}  // namespace percuss::pipeline
