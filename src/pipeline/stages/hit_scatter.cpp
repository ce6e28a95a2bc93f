#include "pipeline/stages/hit_scatter.hpp"

#include <algorithm>
#include <iterator>
#include <map>

#include "identify/hits/hit_scatter.hpp"

namespace percuss::pipeline {
namespace {

// The points' places in the set: ascending by number.
std::map<int, std::size_t> places_of_points(const TestSpectra& spectra) {
  std::map<int, std::size_t> places;
  for (const std::size_t h : accepted_hits(spectra.hits)) places[spectra.hits[h].point] = 0;
  std::size_t next = 0;
  for (auto& [point, place] : places) place = next++;
  return places;
}

// The hits that are compared. The spectrum of a double contact has zeros, near which the FRF of this hit alone is poor.
// Such hits are left out where two other hits remain.
std::vector<std::size_t> compared_hits(const TestSpectra& spectra) {
  const std::vector<std::size_t> used = accepted_hits(spectra.hits);
  std::vector<std::size_t> single;
  std::copy_if(used.begin(), used.end(), std::back_inserter(single), [&](std::size_t h) {
    const std::vector<acquire::Finding>& findings = spectra.hits[h].hit.findings;
    return std::none_of(findings.begin(), findings.end(),
                        [](const auto& finding) { return finding.code == acquire::FindingCode::double_hit; });
  });
  return single.size() < 2 ? used : single;
}

}  // namespace

void add_scatter_between_hits(const identify::FrfDataset& set, const TestSpectra& spectra,
                              const identify::IdentifyOptions& options, std::vector<identify::Mode>& modes) {
  const std::vector<std::size_t> used = compared_hits(spectra);
  if (used.size() < 2) return;
  const auto places = places_of_points(spectra);
  identify::HitFrfs hits{.set = {.lines = set.lines, .usable_bandwidth_Hz = set.usable_bandwidth_Hz}};
  std::vector<double> peak_N;
  for (const std::size_t h : used) {
    const acquire::Hit& hit = spectra.hits[h].hit;
    std::vector<frf::ForceBlock> block{frf::force_block(hit, spectra.lines.fs_Hz, spectra.window_decay_per_s)};
    hits.set.points.push_back(identify::point_force(std::move(block), {spectra.force[h]}, spectra.lines, hit.noise_N));
    hits.points.push_back(places.at(spectra.hits[h].point));
    for (std::size_t c = 0; c < spectra.responses.of[h].size(); ++c) {
      hits.set.channels.push_back({.point = hits.points.size() - 1, .channel = c, .frf = {}});
      hits.accel.push_back(spectra.responses.of[h][c].spectrum);
    }
    peak_N.push_back(hit.peak_N);
  }
  identify::WindowedHitPoles linear = identify::windowed_hit_poles(set, hits, modes);
  if (options.start_Hz.empty() && !options.modes) {
    const auto left_Hz = identify::without_imitated_modes(set, hits, linear, peak_N, modes);
    if (!left_Hz.empty()) {
      modes = identify::identify_modes(set, {.effort = options.effort, .start_Hz = left_Hz});
      linear = identify::windowed_hit_poles(set, hits, modes);
    }
  }
  identify::add_hit_scatter(set, hits, linear, peak_N, modes);
}

}  // namespace percuss::pipeline
