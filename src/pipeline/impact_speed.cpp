#include "pipeline/impact_speed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "core/math/statistics.hpp"
#include "metrics/deflection/impact_onset.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kRinging = 8;  // samples before the onset that the ringing of an anti-alias filter may disturb

// The time of the first touch, interpolated between samples: from the force, or from the accelerometer that moves
// first.
metrics::ImpactOnset onset_of(const acquire::Record& record, const AnalysedHit& impact) {
  const auto refined = [&](std::vector<double>& x) {
    const double from_first_s = onset_from_first_sample_s(impact.hit, record.fs_Hz);
    const auto quiet = static_cast<std::size_t>(from_first_s * record.fs_Hz);
    const std::size_t rest = quiet - std::min(quiet, kRinging);
    const Spread noise = spread_of({x.begin(), x.begin() + static_cast<std::ptrdiff_t>(std::min(rest, x.size()))});
    for (double& value : x) value -= noise.median;
    const auto first = static_cast<std::size_t>(std::lround(metrics::motion_onset_s(x, record.fs_Hz) * record.fs_Hz));
    metrics::ImpactOnset onset = metrics::impact_onset(x, record.fs_Hz, first, noise.robust_std);
    onset.time_s += static_cast<double>(impact.hit.first) / record.fs_Hz;
    return onset;
  };
  std::vector<double> x(impact.hit.samples);
  if (record.has_force) {
    record.read_force_N(impact.hit.row, impact.hit.first, x);
    return refined(x);
  }
  std::optional<metrics::ImpactOnset> earliest;
  for (std::size_t c = 0; c < record.accel.size(); ++c) {
    record.read_accel_mps2(impact.hit.row, c, impact.hit.first, x);
    const metrics::ImpactOnset onset = refined(x);
    if (!earliest || onset.time_s < earliest->time_s) earliest = onset;
  }
  return *earliest;
}

}  // namespace

double onset_from_first_sample_s(const acquire::Hit& hit, double fs_Hz) {
  return std::max(0.0, hit.onset_s - static_cast<double>(hit.first) / fs_Hz);
}

std::vector<ImpactSpeed> impact_speeds(const Analysis& analysis, const std::vector<AnalysedHit>& impacts,
                                       const std::vector<std::size_t>& hits, const ImpactTestOptions& options) {
  std::vector<ImpactSpeed> out;
  if (!options.beam_distance_m) return out;
  const double sample_s = 1 / analysis.record().fs_Hz;
  for (const std::size_t h : hits) {
    const metrics::ImpactOnset onset = onset_of(analysis.record(), impacts[h]);
    const double time_s = onset.time_s - options.beam_time_s;
    if (!(time_s > sample_s)) {
      throw InputError(fmt::format("the time from the light beam to hit {} is {:.6g} s", h + 1, time_s),
                       analysis.record().source(), "correct the time of the light beam, or leave out its distance",
                       {"beam_time", "beam_distance"});
    }
    const double speed = *options.beam_distance_m / time_s;
    out.push_back({.hit = h, .speed_mps = speed, .std_mps = speed * onset.std_s / time_s});
  }
  return out;
}

}  // namespace percuss::pipeline
