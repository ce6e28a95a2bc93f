#include "synth/schedule.hpp"

#include "synth/random_stream.hpp"

namespace percuss::synth {
namespace {

constexpr std::uint64_t kHitStream = 1;

double planned_onset_s(const SynthSpec& spec, std::size_t hit, double random) {
  if (spec.layout == SynthLayout::rows) return spec.pretrigger_s + spec.onset_spread_s * random;
  if (!spec.hit_times_s.empty()) return spec.hit_times_s[hit];
  const double spacing_s = static_cast<double>(spec.samples) / spec.fs_Hz / static_cast<double>(spec.hits);
  return (static_cast<double>(hit) + 0.2 + 0.3 * random) * spacing_s;  // early in the interval of each hit
}

void apply(const SynthFault& fault, TrueHit& hit) {
  switch (fault.kind) {
    case SynthFaultKind::double_hit:
      hit.flag = "double";
      hit.second_delay_s = fault.delay_s;
      hit.second_peak_N = fault.ratio * hit.peak_N;
      break;
    case SynthFaultKind::weak:
      hit.flag = "weak";
      hit.peak_N *= fault.ratio;
      hit.second_peak_N *= fault.ratio;
      break;
    case SynthFaultKind::missing:
      hit.flag = "missing";
      hit.peak_N = hit.second_peak_N = hit.second_delay_s = 0;
      break;
    case SynthFaultKind::late:
      hit.flag = "late";
      hit.onset_s = -fault.delay_s;
      break;
    case SynthFaultKind::reversed:
      hit.flag = "reversed";
      hit.reversed = true;
      break;
  }
}

}  // namespace

std::vector<TrueHit> schedule_hits(const SynthSpec& spec) {
  std::vector<TrueHit> hits;
  for (std::size_t i = 0; i < spec.hits * spec.points.size(); ++i) {
    RandomStream random{spec.seed, kHitStream, i};
    TrueHit hit;
    hit.row = spec.layout == SynthLayout::rows ? i : 0;
    hit.point = i / spec.hits;
    hit.onset_s = planned_onset_s(spec, i, random.uniform());
    hit.width_s = spec.pulse.width_s * (1 + random.uniform(-spec.pulse.width_spread, spec.pulse.width_spread));
    hit.peak_N = spec.pulse.peak_N * (1 + random.uniform(-spec.pulse.peak_spread, spec.pulse.peak_spread));
    for (const SynthFault& fault : spec.faults) {
      if (fault.hit == i) apply(fault, hit);
    }
    hits.push_back(hit);
  }
  return hits;
}

std::vector<Pulse> pulses_of(const SynthSpec& spec, const TrueHit& hit) {
  std::vector<Pulse> pulses;
  if (hit.peak_N != 0) pulses.push_back({spec.pulse.kind, hit.onset_s, hit.width_s, hit.peak_N});
  if (hit.second_peak_N != 0) {
    pulses.push_back({spec.pulse.kind, hit.onset_s + hit.second_delay_s, hit.width_s, hit.second_peak_N});
  }
  return pulses;
}

std::size_t rows_per_run(const SynthSpec& spec) {
  return spec.layout == SynthLayout::continuous ? 1 : spec.hits * spec.points.size();
}

}  // namespace percuss::synth
