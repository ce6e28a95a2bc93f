#include "pipeline/hits/correct_responses.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"
#include "core/parallel/parallel.hpp"
#include "frf/spectra.hpp"
#include "pipeline/findings/sample_prediction.hpp"
#include "pipeline/hits/motion_before.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kShock_s = 0.005;       // after the blow: the largest motion comes within this time
constexpr std::size_t kMaxSuspects = 6;  // samples of one response that are looked at
constexpr double kMaterialFault = 1e-9;  // of the largest response: smaller faults are rounding errors
constexpr std::size_t kAfterPulse = 16;  // samples: the force still acts
constexpr std::size_t kSearchStep = 80;  // samples: a diagnosis reaches 44 to either side
constexpr double kEarlyPart = 0.25;      // of the decay: it is searched everywhere
constexpr double kToneBefore_s = 0.1;    // before a hit: some periods of hum
constexpr std::size_t kSameFault = 48;   // samples: nearer suspects are one fault
constexpr double kClearOfTones = 2;      // size of a step over the mean of wandering tones before the hit

using Samples = std::vector<std::vector<double>>;  // [channels]

std::size_t end_of_pulse(const acquire::Hit& hit) {
  return hit.gate_first - hit.first + hit.gated_N.size() + kAfterPulse;
}

std::vector<std::size_t> suspects(const std::vector<HitResponse>& responses, const DecayRange& range) {
  std::vector<std::size_t> all;
  for (const HitResponse& response : responses) {
    const double least = kMaterialFault * response.grade.extremes.max_distance_from(0);
    const auto of_channel = outstanding_samples(response.noise.after, kMaxSuspects, least);
    all.insert(all.end(), of_channel.begin(), of_channel.end());
  }
  std::erase_if(all,
                [&](std::size_t at) { return at < range.first + kDiagnosisRoom || at + kDiagnosisRoom > range.end; });
  std::sort(all.begin(), all.end());
  const auto same = [](std::size_t a, std::size_t b) { return b - a < kSameFault; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

Samples read_from(const acquire::Record& record, const acquire::Hit& hit, std::size_t first, std::size_t samples) {
  Samples out(record.accel.size());
  for (std::size_t c = 0; c < out.size(); ++c) {
    out[c].resize(samples);
    record.read_accel_mps2(hit.row, c, first, out[c]);
  }
  return out;
}

Samples read_all(const acquire::Record& record, const acquire::Hit& hit, std::size_t samples) {
  return read_from(record, hit, hit.first, samples);
}

// The samples of the row just before those of the hit.
Samples read_before(const acquire::Record& record, const acquire::Hit& hit) {
  const std::size_t samples = std::min(hit.first, static_cast<std::size_t>(kToneBefore_s * record.fs_Hz));
  return read_from(record, hit, hit.first - samples, samples);
}

std::vector<std::span<const double>> views_of(const Samples& samples) { return {samples.begin(), samples.end()}; }

bool same_fault(const std::vector<SampleFault>& faults, const SampleFault& fault) {
  return std::any_of(faults.begin(), faults.end(), [&](const SampleFault& other) {
    return other.first + kSameFault > fault.first && fault.first + kSameFault > other.first;
  });
}

std::vector<SampleFault> find_faults(const Samples& samples, const std::vector<std::size_t>& at,
                                     const DecayRange& range) {
  std::vector<SampleFault> faults;
  const auto channels = views_of(samples);
  for (const std::size_t sample : at) {
    auto fault = diagnose_samples(channels, sample, range);
    if (fault && !same_fault(faults, *fault)) faults.push_back(std::move(*fault));
  }
  return faults;
}

bool has_gap(const HitFaults& found) {
  return std::any_of(found.faults.begin(), found.faults.end(),
                     [](const SampleFault& fault) { return fault.kind == SampleFault::Kind::missing; });
}

bool repairable(const SampleFault& fault) { return fault.kind != SampleFault::Kind::jump; }

std::optional<BaselineChange> baseline_change(const HitResponse& response, std::size_t samples, double fs_Hz) {
  const double largest = response.grade.extremes.max_distance_from(response.rest.before.value_or(0));
  return find_baseline_change(response.rest, samples, largest, fs_Hz);
}

// The sample at which a sensor is overloaded: the largest within kShock_s of the blow.
std::size_t sample_of_shock(const acquire::Hit& hit, double fs_Hz, const std::vector<double>& x) {
  const std::size_t first = hit.gate_first - hit.first;
  const std::size_t end = std::min(x.size(), hit.peak - hit.first + static_cast<std::size_t>(kShock_s * fs_Hz) + 1);
  const auto smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto at = [&](std::size_t n) { return x.begin() + static_cast<std::ptrdiff_t>(n); };
  return static_cast<std::size_t>(std::max_element(at(first), at(end), smaller) - x.begin());
}

// Subtracts the response's baseline from its samples `x`, which have the levels response.rest. A step that these
// samples do not confirm is dropped. Returns whether a baseline was subtracted.
bool subtract_confirmed(HitResponse& response, const acquire::Hit& hit, double fs_Hz, std::vector<double>& x) {
  if (response.baseline && response.baseline->step && !keeps_its_sign(response.rest, x)) response.baseline.reset();
  if (!response.baseline) return false;
  subtract_baseline(*response.baseline, sample_of_shock(hit, fs_Hz, x), fs_Hz, x);
  return true;
}

enum class Search { suspects, everywhere };

// Samples at equal steps over the first part of the decay. A diagnosis at each of them covers all samples between.
std::vector<std::size_t> everywhere(const DecayRange& range) {
  std::vector<std::size_t> at;
  const std::size_t end =
      range.first + static_cast<std::size_t>(kEarlyPart * static_cast<double>(range.end - range.first));
  for (std::size_t n = range.first + kDiagnosisRoom; n + kDiagnosisRoom < end; n += kSearchStep) at.push_back(n);
  return at;
}

// The samples of a hit with the faults repaired and the baseline removed; empty where nothing is wrong.
Samples corrected_hit(HitFaults& found, HitResponses& responses, const acquire::Record& record, const acquire::Hit& hit,
                      std::size_t samples, Search search) {
  const DecayRange decay{.first = end_of_pulse(hit), .end = samples};
  std::vector<std::size_t> at = suspects(responses.of[found.hit], decay);
  if (search == Search::everywhere) {
    const auto more = everywhere(decay);
    at.insert(at.end(), more.begin(), more.end());
  }
  bool moves = false;
  for (HitResponse& response : responses.of[found.hit]) {
    response.baseline = baseline_change(response, samples, record.fs_Hz);
    moves = moves || response.baseline;
  }
  if (at.empty() && !moves) return {};
  Samples read = read_all(record, hit, samples);
  moves = false;
  for (std::size_t c = 0; c < read.size(); ++c) {
    HitResponse& response = responses.of[found.hit][c];
    if (response.baseline && !exceeds_motion_before(*response.baseline, read[c], response.rest.quiet))
      response.baseline.reset();
    moves = moves || response.baseline;
  }
  if (!at.empty()) found.faults = find_faults(read, at, decay);
  const bool faulty = std::any_of(found.faults.begin(), found.faults.end(), repairable);
  if (!faulty && !moves) return {};
  if (faulty) read = repaired(views_of(read), found.faults);
  moves = false;
  for (std::size_t c = 0; c < read.size(); ++c)
    moves = subtract_confirmed(responses.of[found.hit][c], hit, record.fs_Hz, read[c]) || moves;
  if (!faulty && !moves) return {};
  return read;
}

// The mean that wandering tones may have over the samples before the hit.
double mean_of_wandering(const ToneFit& fit, std::size_t signal, double quiet_s) {
  double mean = 0;
  for (std::size_t t = 0; t < fit.tones.size(); ++t) {
    if (fit.tones[t].wanders) mean += largest_mean(std::abs(fit.amplitudes[signal][t]), fit.tones[t].freq_Hz, quiet_s);
  }
  return mean;
}

// Finds the baselines of a hit again, in its samples without the tones. Hum has a mean over the few samples before the
// hit, which looks like a step, or hides one. No sinusoid describes a tone that wanders: a step must exceed its mean.
// samples       without the tones, and without the baselines found beside them
// first_signal  signal of the fit: the first channel of this hit
void find_baselines_without_tones(std::vector<HitResponse>& of_hit, Samples& samples, const HitFaults& found,
                                  const ToneFit& fit, std::size_t first_signal, const acquire::Record& record,
                                  const acquire::Hit& hit) {
  Samples with_baseline;
  if (std::any_of(of_hit.begin(), of_hit.end(), [](const HitResponse& one) { return one.baseline.has_value(); })) {
    with_baseline = read_all(record, hit, samples.front().size());
    if (std::any_of(found.faults.begin(), found.faults.end(), repairable))
      with_baseline = repaired(views_of(with_baseline), found.faults);
  }
  for (std::size_t c = 0; c < of_hit.size(); ++c) {
    HitResponse& response = of_hit[c];
    if (response.baseline) {
      samples[c] = std::move(with_baseline[c]);
      subtract_tones(fit, first_signal + c, record.fs_Hz, samples[c]);
    }
    response.rest = rest_levels(samples[c], response.rest.quiet, response.rest.first);
    response.baseline = baseline_change(response, samples[c].size(), record.fs_Hz);
    const double quiet_s = static_cast<double>(response.rest.quiet) / record.fs_Hz;
    if (response.baseline &&
        std::abs(response.baseline->size) < kClearOfTones * mean_of_wandering(fit, first_signal + c, quiet_s))
      response.baseline.reset();
    subtract_confirmed(response, hit, record.fs_Hz, samples[c]);
  }
}

std::vector<ToneSignal> signals_of(const HitResponses& responses, const acquire::Hit& hit, std::size_t h,
                                   const Samples& samples, const Samples& before) {
  std::vector<ToneSignal> signals;
  for (std::size_t c = 0; c < samples.size(); ++c) {
    signals.push_back({.x = samples[c],
                       .hit = h,
                       .pulse_N = hit.gated_N,
                       .pulse_first = hit.gate_first - hit.first,
                       .quiet = hit.gate_first > hit.first ? hit.gate_first - hit.first : 0,
                       .largest = responses.of[h][c].grade.extremes.max_distance_from(0),
                       .before = before[c]});
  }
  return signals;
}

// Candidates from the first hit. Its responses were searched when they were read; corrected samples are searched again.
std::vector<double> candidates_for_tones(const std::vector<HitResponse>& responses, const Samples& corrected) {
  std::vector<double> all;
  for (std::size_t c = 0; c < responses.size(); ++c) {
    const auto of_channel = corrected.empty() ? responses[c].tone_candidates : tone_candidates(corrected[c]);
    all.insert(all.end(), of_channel.begin(), of_channel.end());
  }
  return all;
}

// Searches the first hit for tones, and all hits if it has some. Subtracts the tones from the samples of all hits, and
// finds the baselines again without them. If any hit has corrected samples, only the samples of the lines are searched,
// in all hits: inserted samples shift the samples after them, so that the record does not continue the corrected
// samples.
// returns  [used hits × channels] the amplitude of the tones that wander and thus remain; empty without tones.
std::vector<double> remove_tones(HitResponses& responses, std::vector<Samples>& corrected,
                                 const std::vector<HitFaults>& found, const acquire::Record& record,
                                 const std::vector<AnalysedHit>& hits, const TransformOptions& options) {
  const std::vector<std::size_t> used = accepted_hits(hits);
  const bool any_corrected =
      std::any_of(corrected.begin(), corrected.end(), [](const Samples& samples) { return !samples.empty(); });
  const std::size_t searched =
      any_corrected ? options.lines.samples : std::max(options.lines.samples, options.tone_samples);
  const auto samples_of = [&](std::size_t u) {
    return corrected[u].empty() ? read_all(record, hits[used[u]].hit, searched) : corrected[u];
  };
  std::vector<double> candidates = candidates_for_tones(responses.of[used[0]], corrected[0]);
  if (candidates.empty()) return {};
  std::vector<Samples> samples(used.size()), before(used.size());
  std::vector<ToneSignal> signals;
  for (std::size_t u = 0; u < used.size(); ++u) {
    samples[u] = samples_of(u);
    before[u] = read_before(record, hits[used[u]].hit);
    const auto of_hit = signals_of(responses, hits[used[u]].hit, used[u], samples[u], before[u]);
    signals.insert(signals.end(), of_hit.begin(), of_hit.end());
  }
  const ToneFit fit = find_tones(signals, std::move(candidates), record.fs_Hz);
  if (fit.tones.empty()) return {};
  responses.tones = fit.tones;
  const std::size_t channels = record.accel.size();
  parallel_for(signals.size(), options.threads, [&](std::size_t s) {
    std::vector<double>& x = samples[s / channels][s % channels];
    x.resize(options.lines.samples);
    subtract_tones(fit, s, record.fs_Hz, x);
  });
  parallel_for(used.size(), options.threads, [&](std::size_t u) {
    find_baselines_without_tones(responses.of[used[u]], samples[u], found[u], fit, u * channels, record,
                                 hits[used[u]].hit);
  });
  corrected = std::move(samples);
  std::vector<double> remaining(signals.size());
  for (std::size_t s = 0; s < signals.size(); ++s) {
    for (std::size_t t = 0; t < fit.tones.size(); ++t) {
      if (fit.tones[t].wanders) remaining[s] = std::hypot(remaining[s], std::abs(fit.amplitudes[s][t]));
    }
  }
  return remaining;
}

// A response is at rest before its hit if its motion there is not larger than the tones that remain.
void judge_rest_without_tones(acquire::ResponseGrade& grade, const acquire::Hit& hit, std::span<const double> accel,
                              double tones_mps2) {
  const std::size_t quiet = hit.gate_first > hit.first ? hit.gate_first - hit.first : 0;
  if (rms_about_mean(accel.first(std::min(quiet, accel.size()) / 2)) > tones_mps2) return;
  grade.rings_before = grade.may_ring_before = false;
}

}  // namespace

void examine_response(HitResponse& response, const acquire::Hit& hit, std::span<const double> accel_mps2) {
  const std::size_t first = end_of_pulse(hit);
  if (hit.gated_N.empty() || first >= accel_mps2.size()) return;
  const std::size_t quiet = hit.gate_first > hit.first ? hit.gate_first - hit.first : 0;
  // The recorder's filter rings before the pulse. A response may show this ringing even if the force does not.
  const std::size_t silent = quiet > 2 * kFilterBeforePulse ? quiet - kFilterBeforePulse : quiet / 2;
  response.noise = {.after = difference_profile(accel_mps2, first),
                    .before = difference_rms(accel_mps2.first(std::min(silent, accel_mps2.size())))};
  response.rest = rest_levels(accel_mps2, quiet, first);
  response.dropout = find_long_dropout(accel_mps2, first);
}

std::vector<std::vector<double>> repaired(std::span<const std::span<const double>> channels,
                                          const std::vector<SampleFault>& faults) {
  std::vector<std::vector<double>> out;
  std::vector<SampleFault> last_first = faults;  // insertions move the samples after them
  std::sort(last_first.begin(), last_first.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (std::size_t c = 0; c < channels.size(); ++c) {
    std::vector<double> x(channels[c].begin(), channels[c].end());
    for (const SampleFault& fault : last_first) {
      const auto at = x.begin() + static_cast<std::ptrdiff_t>(fault.first);
      const auto length = static_cast<std::ptrdiff_t>(fault.count);
      if (fault.kind == SampleFault::Kind::jump || !fault.channels[c]) continue;
      if (fault.kind == SampleFault::Kind::missing) std::move_backward(at, x.end() - length, x.end());
      const auto expected = fault.repair.col(static_cast<Eigen::Index>(c));
      std::copy(expected.begin(), expected.end(), at);
    }
    out.push_back(std::move(x));
  }
  return out;
}

void correct_responses(HitResponses& responses, const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                       const TransformOptions& options) {
  const std::vector<std::size_t> used = accepted_hits(hits);
  const acquire::LineRange& range = options.lines;
  const std::size_t channels = record.accel.size();
  std::vector<Samples> corrected(used.size());
  std::vector<HitFaults> found(used.size());
  parallel_for(used.size(), options.threads, [&](std::size_t u) {
    found[u].hit = used[u];
    corrected[u] = corrected_hit(found[u], responses, record, hits[used[u]].hit, range.samples, Search::suspects);
  });
  // A recorder that loses samples may lose some at every hit, but a gap does not stand out where the motion hardly
  // changes.
  if (std::any_of(found.begin(), found.end(), has_gap)) {
    parallel_for(used.size(), options.threads, [&](std::size_t u) {
      if (has_gap(found[u])) return;
      corrected[u] = corrected_hit(found[u], responses, record, hits[used[u]].hit, range.samples, Search::everywhere);
    });
  }
  std::vector<double> tones_mps2;
  if (!used.empty()) tones_mps2 = remove_tones(responses, corrected, found, record, hits, options);
  for (HitFaults& faults : found) {
    if (!faults.faults.empty()) responses.faults.push_back(std::move(faults));
  }
  parallel_for(used.size() * channels, options.threads, [&](std::size_t t) {
    const auto& samples = corrected[t / channels];
    if (samples.empty()) return;
    const acquire::Hit& hit = hits[used[t / channels]].hit;
    const std::vector<double>& accel = samples[t % channels];
    HitResponse& response = responses.of[used[t / channels]][t % channels];
    response.grade = acquire::grade_response(hit, accel, record.fs_Hz);
    if (!tones_mps2.empty() && tones_mps2[t] > 0) judge_rest_without_tones(response.grade, hit, accel, tones_mps2[t]);
    response.rest = rest_levels(accel, response.rest.quiet, response.rest.first);
    frf::accel_spectrum(hit, accel, range, options.window_decay_per_s,
                        responses.lines.part(t * range.count, range.count));
  });
}

}  // namespace percuss::pipeline
