#include "pipeline/hits/hit_noise.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <span>

#include "pipeline/hits/motion_before.hpp"

namespace percuss::pipeline {
namespace {

// Limit of the unexplained energy over the energy of the hit's own noise. The noise of the other hits may double the
// unexplained energy, and sixteen samples before a hit determine the energy of the noise only to a third.
constexpr double kClearOfNoise = 4;
// Unexplained energy over the energy of hits at other points: 14 % in amplitude, as 4° beside the node line of a hoop
// mode.
constexpr double kBesideNode = 0.02;
constexpr double kTypicalQuantile = 0.75;  // many points of a survey may lie on node lines

// Σ w² of the exponential window over the samples: the energy of white noise of variance 1 on a spectral line.
double window_energy(const TransformOptions& options) {
  const auto samples = static_cast<double>(options.lines.samples);
  const double exponent = 2 * options.window_decay_per_s / options.lines.fs_Hz;
  return exponent > 0 ? std::expm1(-exponent * samples) / std::expm1(-exponent) : samples;
}

double energy_of(std::span<const Complex> spectrum) {
  double energy = 0;
  for (const Complex& line : spectrum) energy += std::norm(line);
  return energy;
}

std::optional<double> explained_share(const AnalysedHit& hit) {
  for (const acquire::Finding& finding : hit.hit.findings) {
    if (finding.code == acquire::FindingCode::low_coherence) return finding.value;
  }
  return std::nullopt;
}

// Energy of the responses per unit of the force's peak; nothing for a hit without responses.
std::optional<double> excited_energy(const AnalysedHit& hit, const std::vector<HitResponse>& responses) {
  double energy = 0;
  for (const HitResponse& one : responses) energy += energy_of(one.spectrum);
  const double peak_N = hit.hit.peak_N;
  return responses.empty() || peak_N == 0 ? std::nullopt : std::optional(energy / (peak_N * peak_N));
}

bool differs_by_noise(const std::vector<HitResponse>& responses, double explained, double line_energy) {
  double response = 0, noise = 0;
  for (const HitResponse& one : responses) {
    if (!one.rest.before) return false;
    response += energy_of(one.spectrum);
    noise += one.rest.noise * one.rest.noise * line_energy * static_cast<double>(one.spectrum.size());
  }
  return (1 - explained) * response <= kClearOfNoise * noise;
}

}  // namespace

std::set<std::size_t> hits_that_differ_by_noise(const std::vector<AnalysedHit>& hits, const HitResponses& responses,
                                                const TransformOptions& options) {
  const double line_energy = window_energy(options);
  std::set<std::size_t> out;
  for (const std::size_t h : accepted_hits(hits)) {
    const std::optional<double> explained = explained_share(hits[h]);
    if (!explained || h >= responses.of.size() || may_ring_before(hits[h])) continue;
    if (differs_by_noise(responses.of[h], *explained, line_energy)) out.insert(h);
  }
  return out;
}

std::set<std::size_t> hits_on_node_lines(const std::vector<AnalysedHit>& hits, const HitResponses& responses) {
  std::vector<std::optional<double>> energy(hits.size());
  std::vector<double> known;
  for (const std::size_t h : accepted_hits(hits)) {
    if (h >= responses.of.size()) continue;
    energy[h] = excited_energy(hits[h], responses.of[h]);
    if (energy[h]) known.push_back(*energy[h]);
  }
  if (known.empty()) return {};
  const auto typical =
      known.begin() + static_cast<std::ptrdiff_t>(kTypicalQuantile * static_cast<double>(known.size()));
  std::nth_element(known.begin(), typical, known.end());
  std::set<std::size_t> out;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    const std::optional<double> explained = explained_share(hits[h]);
    if (energy[h] && explained && (1 - *explained) * *energy[h] <= kBesideNode * *typical) out.insert(h);
  }
  return out;
}

}  // namespace percuss::pipeline
