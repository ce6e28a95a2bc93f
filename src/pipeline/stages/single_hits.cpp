#include "pipeline/stages/single_hits.hpp"

#include <algorithm>
#include <iterator>

#include "core/parallel/parallel.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kFlopsPerLine = 10;  // of the power of a force

}  // namespace

std::map<int, std::size_t> places_of_points(const TestSpectra& spectra) {
  std::map<int, std::size_t> places;
  for (const std::size_t h : accepted_hits(spectra.hits)) places[spectra.hits[h].point] = 0;
  std::size_t next = 0;
  for (auto& [point, place] : places) place = next++;
  return places;
}

std::vector<std::size_t> comparable_hits(const TestSpectra& spectra) {
  const std::vector<std::size_t> used = accepted_hits(spectra.hits);
  std::vector<std::size_t> single;
  std::copy_if(used.begin(), used.end(), std::back_inserter(single), [&](std::size_t h) {
    const std::vector<acquire::Finding>& findings = spectra.hits[h].hit.findings;
    return std::none_of(findings.begin(), findings.end(),
                        [](const auto& finding) { return finding.code == acquire::FindingCode::double_hit; });
  });
  return single.size() < 2 ? used : single;
}

identify::HitFrfs single_hits(const identify::FrfDataset& set, const TestSpectra& spectra,
                              const std::vector<std::size_t>& hits) {
  const auto places = places_of_points(spectra);
  identify::HitFrfs single{.set = {.lines = set.lines, .usable_bandwidth_Hz = set.usable_bandwidth_Hz}};
  single.set.points.resize(hits.size());
  parallel_for_cost(hits.size(), kFlopsPerLine * spectra.lines.count, [&](std::size_t i) {
    const acquire::Hit& hit = spectra.hits[hits[i]].hit;
    std::vector<frf::ForceBlock> block{frf::force_block(hit, spectra.lines.fs_Hz, spectra.window_decay_per_s)};
    single.set.points[i] =
        identify::point_force(std::move(block), {spectra.force[hits[i]]}, spectra.lines, hit.noise_N);
  });
  for (const std::size_t h : hits) {
    single.points.push_back(places.at(spectra.hits[h].point));
    for (std::size_t c = 0; c < spectra.responses.of[h].size(); ++c) {
      single.set.channels.push_back({.point = single.points.size() - 1, .channel = c, .frf = {}});
      single.accel.push_back(spectra.responses.of[h][c].spectrum);
    }
  }
  return single;
}

}  // namespace percuss::pipeline
