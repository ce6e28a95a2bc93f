#include "pipeline/stages/frf_averages.hpp"

#include <map>

#include "core/math/statistics.hpp"
#include "core/parallel/parallel.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kFlopsPerHitLine = 20;  // a few complex products per hit and line

// Hits by their point, ascending.
std::map<int, std::vector<std::size_t>> by_point(const std::vector<AnalysedHit>& hits,
                                                 const std::vector<std::size_t>& which) {
  std::map<int, std::vector<std::size_t>> points;
  for (const std::size_t h : which) points[hits[h].point].push_back(h);
  return points;
}

double usable_bandwidth_Hz(const std::vector<AnalysedHit>& hits, const std::vector<std::size_t>& which) {
  std::vector<double> bandwidth_Hz;
  bandwidth_Hz.reserve(which.size());
  for (const std::size_t h : which) bandwidth_Hz.push_back(hits[h].hit.bandwidth_Hz);
  return median(bandwidth_Hz);
}

identify::PointForce force_at_point(const TestSpectra& spectra, const std::vector<std::size_t>& members) {
  std::vector<frf::ForceBlock> blocks;
  std::vector<double> noise_N;
  std::vector<frf::Spectrum> force;
  for (const std::size_t h : members) {
    const acquire::Hit& hit = spectra.hits[h].hit;
    blocks.push_back(frf::force_block(hit, spectra.lines.fs_Hz, spectra.window_decay_per_s));
    noise_N.push_back(hit.noise_N);
    force.push_back(spectra.force[h]);
  }
  return identify::point_force(std::move(blocks), std::move(force), spectra.lines, median(noise_N));
}

std::vector<std::span<const Complex>> responses_of(const TestSpectra& spectra, const std::vector<std::size_t>& members,
                                                   std::size_t channel) {
  std::vector<std::span<const Complex>> accel;
  accel.reserve(members.size());
  for (const std::size_t h : members) accel.push_back(spectra.responses.of[h][channel].spectrum);
  return accel;
}

}  // namespace

std::vector<FrfGroup> frf_groups(const std::vector<AnalysedHit>& hits, std::size_t channels) {
  std::vector<FrfGroup> groups;
  for (const auto& [point, members] : by_point(hits, accepted_hits(hits))) {
    for (std::size_t c = 0; c < channels; ++c)
      groups.push_back({.index = groups.size(), .point = point, .channel = c, .hits = members});
  }
  return groups;
}

std::size_t average_cost_flops(std::size_t lines, std::size_t hits) { return kFlopsPerHitLine * lines * hits; }

acquire::PointFrf average_frf(const FrfGroup& group, const TestSpectra& spectra, frf::Estimator estimator) {
  std::vector<std::span<const Complex>> force;
  force.reserve(group.hits.size());
  for (const std::size_t h : group.hits) force.emplace_back(spectra.force[h].get(), spectra.lines.count);
  const auto products = frf::cross_spectra(force, responses_of(spectra, group.hits, group.channel));
  return {.point = group.point, .channel = group.channel, .frf = frf::estimate_frf(products, spectra.lines, estimator)};
}

identify::FrfDataset h1_dataset(const TestSpectra& spectra, const std::vector<std::size_t>& hits, std::size_t channels,
                                const std::vector<acquire::PointFrf>* averages) {
  identify::FrfDataset set{.lines = spectra.lines, .usable_bandwidth_Hz = usable_bandwidth_Hz(spectra.hits, hits)};
  std::vector<std::vector<std::size_t>> members;
  for (auto& [point, hits_there] : by_point(spectra.hits, hits)) members.push_back(std::move(hits_there));
  set.points.resize(members.size());
  set.channels.resize(members.size() * channels);
  const std::size_t cost = average_cost_flops(spectra.lines.count, hits.size()) / members.size();
  parallel_for_cost(members.size(), cost, [&](std::size_t p) {
    set.points[p] = force_at_point(spectra, members[p]);
    for (std::size_t c = 0; c < channels; ++c) {
      const std::size_t o = p * channels + c;
      set.channels[o] = {.point = p,
                         .channel = c,
                         .frf = averages != nullptr
                                    ? (*averages)[o].frf.value
                                    : identify::h1_at(set.points[p], responses_of(spectra, members[p], c))};
    }
  });
  return set;
}

}  // namespace percuss::pipeline
