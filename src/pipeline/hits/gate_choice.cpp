#include "pipeline/hits/gate_choice.hpp"

#include <algorithm>
#include <map>

#include "core/parallel/parallel.hpp"
#include "frf/leave_one_out.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kClearlyLess = 0.9;  // of the error with the whole force: below it the tail is not a force

bool has_tail(const AnalysedHit& hit) { return hit.accepted && hit.hit.tail_end > hit.hit.pulse_end; }

acquire::Hit without_tail(acquire::Hit hit) {
  const auto at = [&](std::size_t sample) {
    return hit.gated_N.begin() + static_cast<std::ptrdiff_t>(sample - hit.gate_first);
  };
  std::fill(at(hit.pulse_end), at(hit.tail_end), 0.0);
  if (at(hit.tail_end) == hit.gated_N.end()) hit.gated_N.resize(hit.pulse_end - hit.gate_first);
  hit.tail_end = hit.pulse_end;
  return hit;
}

// The sum of the leave-one-out errors of the hits of one point.
double error_of(const std::vector<AnalysedHit>& hits, const std::vector<std::size_t>& members,
                const HitResponses& responses, const TransformOptions& options, bool whole) {
  std::vector<std::vector<Complex>> spectra;
  std::vector<std::span<const Complex>> force;
  std::vector<std::vector<std::span<const Complex>>> accel;
  for (const std::size_t h : members) {
    const acquire::Hit hit = whole ? hits[h].hit : without_tail(hits[h].hit);
    spectra.push_back(
        frf::force_spectrum(frf::force_block(hit, options.lines.fs_Hz, options.window_decay_per_s), options.lines));
    accel.emplace_back();
    for (const HitResponse& response : responses.of[h]) accel.back().push_back(response.spectrum);
  }
  force.reserve(spectra.size());
  for (const auto& spectrum : spectra) force.emplace_back(spectrum);
  double sum = 0;
  for (const double error : frf::leave_one_out_error(force, accel)) sum += error;
  return sum;
}

}  // namespace

bool any_tail(const std::vector<AnalysedHit>& hits) { return std::any_of(hits.begin(), hits.end(), has_tail); }

void choose_gate(std::vector<AnalysedHit>& hits, const HitResponses& responses, const TransformOptions& options) {
  std::map<int, std::vector<std::size_t>> points;
  for (const std::size_t h : accepted_hits(hits)) points[hits[h].point].push_back(h);
  std::vector<std::vector<std::size_t>> groups;
  for (auto& [point, members] : points) {
    const bool tail = std::any_of(members.begin(), members.end(), [&](std::size_t h) { return has_tail(hits[h]); });
    if (tail && members.size() > 1) groups.push_back(std::move(members));
  }
  std::vector<double> whole(groups.size()), pulses(groups.size());
  parallel_for(groups.size(), options.threads, [&](std::size_t g) {
    whole[g] = error_of(hits, groups[g], responses, options, true);
    pulses[g] = error_of(hits, groups[g], responses, options, false);
  });
  double with = 0, without = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    with += whole[g];
    without += pulses[g];
  }
  if (!(without < kClearlyLess * with)) return;
  for (AnalysedHit& hit : hits) {
    if (hit.hit.tail_end > hit.hit.pulse_end) hit.hit = without_tail(std::move(hit.hit));
  }
}

}  // namespace percuss::pipeline
