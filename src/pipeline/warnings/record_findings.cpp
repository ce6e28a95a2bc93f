#include "pipeline/warnings/record_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "core/math/statistics.hpp"
#include "core/units.hpp"
#include "pipeline/warnings/force_findings.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMaxListed = 8;  // hits or tones in one message
constexpr const char* kStopMachine = "look for a machine nearby, and measure while it stands still";
constexpr double kMainsDeviation = 0.005;  // of the mains' frequency from 50 or 60 Hz

// One kind of fault over all hits: the place of the first in each hit, the largest size of all.
struct FaultSummary {
  std::string where;  // "hit 1 (3 samples, 81.3 ms after the blow), …"
  std::size_t hits = 0;
  double size_mps2 = 0;
};

template <class Predicate>
FaultSummary summary_of(const std::vector<HitFaults>& faults, const acquire::Record& record,
                        const std::vector<AnalysedHit>& hits, Predicate&& concerns) {
  FaultSummary out;
  for (const HitFaults& of_hit : faults) {
    const auto fault = std::find_if(of_hit.faults.begin(), of_hit.faults.end(), concerns);
    if (fault == of_hit.faults.end()) continue;
    const acquire::Hit& hit = hits[of_hit.hit].hit;
    const double after_s =
        (static_cast<double>(hit.first + fault->first) - static_cast<double>(hit.peak)) / record.fs_Hz;
    if (out.hits < kMaxListed) {
      out.where += fmt::format("{}hit {} ({} sample{}, {:.4g} ms after the blow)", out.hits == 0 ? "" : ", ",
                               of_hit.hit + 1, fault->count, fault->count == 1 ? "" : "s", after_s * 1e3);
    }
    ++out.hits;
    for (auto other = fault; other != of_hit.faults.end(); ++other) {
      if (concerns(*other)) out.size_mps2 = std::max(out.size_mps2, other->size);
    }
  }
  if (out.hits > kMaxListed)
    out.where += fmt::format(" and {} more hit{}", out.hits - kMaxListed, out.hits - kMaxListed == 1 ? "" : "s");
  return out;
}

bool is_missing(const SampleFault& fault) { return fault.kind == SampleFault::Kind::missing; }
bool is_dropout(const SampleFault& fault) {
  return fault.kind == SampleFault::Kind::wrong && (fault.constant || fault.count > 2);
}
bool is_spike(const SampleFault& fault) { return fault.kind == SampleFault::Kind::wrong && !is_dropout(fault); }

// Largest magnitude of all graded responses, m/s².
double largest_response(const std::vector<AnalysedHit>& hits) {
  double largest = 0;
  for (const AnalysedHit& hit : hits) {
    for (const acquire::ResponseGrade& grade : hit.responses)
      largest = std::max({largest, grade.extremes.high, -grade.extremes.low});
  }
  return largest;
}

std::string tone_list(std::vector<Tone> tones) {
  std::stable_sort(tones.begin(), tones.end(), [](const Tone& a, const Tone& b) { return a.share > b.share; });
  std::string list;
  for (std::size_t t = 0; t < std::min(tones.size(), kMaxListed); ++t)
    list += fmt::format("{}{:.2f} Hz ({:.2g} %)", t == 0 ? "" : ", ", tones[t].freq_Hz, tones[t].share * 100);
  if (tones.size() > kMaxListed) list += fmt::format(" and {} smaller ones", tones.size() - kMaxListed);
  return list;
}

bool is_of_mains(double freq_Hz) {
  constexpr std::array kMains_Hz = {50.0, 60.0};
  return std::any_of(kMains_Hz.begin(), kMains_Hz.end(), [&](double mains_Hz) {
    const double order = std::round(freq_Hz / mains_Hz);
    return order >= 1 && std::abs(freq_Hz - order * mains_Hz) < kMainsDeviation * order * mains_Hz &&
           std::abs(freq_Hz - order * mains_Hz) < 0.1 * mains_Hz;
  });
}

}  // namespace

std::vector<Warning> fault_warnings(const std::vector<HitFaults>& faults, const acquire::Record& record,
                                    const std::vector<AnalysedHit>& hits) {
  std::vector<Warning> out;
  const double largest = largest_response(hits);
  if (const FaultSummary lost = summary_of(faults, record, hits, is_missing); lost.hits > 0) {
    out.push_back(with_remedy(
        {"lost_samples", "the recorder lost samples: all channels jump ahead in " + lost.where +
                             ". Samples predicted from both sides close the gap, so the modes describe the whole "
                             "decay"},
        "record again with a lower sampling rate, fewer channels or a faster disk"));
  }
  if (const FaultSummary dropped = summary_of(faults, record, hits, is_dropout); dropped.hits > 0) {
    out.push_back(with_remedy(
        {"dropout", fmt::format("the accelerometers drop out in {}: the samples there are off by up to {:.2g} % of the "
                                "largest response. Samples predicted from both sides replace them",
                                dropped.where, 100 * dropped.size_mps2 / largest)},
        "check cables and connectors"));
  }
  if (const FaultSummary spikes = summary_of(faults, record, hits, is_spike); spikes.hits > 0) {
    out.push_back(
        with_remedy({"spike", fmt::format("single samples stand out by up to {:.2g} % of the largest response in {}. "
                                          "Samples predicted from both sides replace them",
                                          100 * spikes.size_mps2 / largest, spikes.where)},
                    "check cables and earthing"));
  }
  return out;
}

std::vector<Warning> long_dropout_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                           const HitResponses& responses) {
  std::string where;
  std::size_t concerned = 0;
  for (const std::size_t h : accepted_hits(hits)) {
    std::optional<LongDropout> longest;
    for (const HitResponse& response : responses.of[h]) {
      if (response.dropout && (!longest || response.dropout->count > longest->count)) longest = response.dropout;
    }
    if (!longest || ++concerned > kMaxListed) continue;
    const acquire::Hit& hit = hits[h].hit;
    const double after_s =
        (static_cast<double>(hit.first + longest->first) - static_cast<double>(hit.peak)) / record.fs_Hz;
    where += fmt::format("{}hit {} ({} samples, {:.4g} ms after the blow{})", concerned == 1 ? "" : ", ", h + 1,
                         longest->count, after_s * 1e3, longest->to_end ? ", to the end" : "");
  }
  if (concerned == 0) return {};
  if (concerned > kMaxListed)
    where += fmt::format(" and {} more hit{}", concerned - kMaxListed, concerned - kMaxListed == 1 ? "" : "s");
  return {with_remedy({"dropout",
                       "the accelerometers drop out in " + where +
                           ": too long to predict the samples. Frequencies, damping and residues are off by more "
                           "than their ±",
                       {"reject_hit"}},
                      "check cables and connectors, and reject these hits")};
}

std::vector<Warning> tone_warnings(const std::vector<Tone>& tones) {
  std::vector<Tone> mains, steady, wandering;
  for (const Tone& tone : tones)
    (tone.wanders ? wandering : is_of_mains(tone.freq_Hz) ? mains : steady).push_back(tone);
  std::vector<Warning> out;
  if (!mains.empty()) {
    out.push_back(with_remedy(
        {"hum",
         "hum of the mains and its harmonics, with their size relative to the largest response: " + tone_list(mains) +
             ". These sinusoids were fitted to the end of each response and removed. A mode within a few "
             "spectral lines of one is less certain than its ± says"},
        "check the earthing, and keep cables away from power lines"));
  }
  if (!steady.empty()) {
    out.push_back(with_remedy(
        {"tone",
         "steady tones that no hit excites, with their size relative to the largest response: " + tone_list(steady) +
             ". They were fitted to the end of each response and removed. A mode within a few "
             "spectral lines of one is less certain than its ± says"},
        kStopMachine));
  }
  if (!wandering.empty()) {
    out.push_back(with_remedy({"tone",
                               "tones that no hit excites and whose phase wanders, with their size relative to the "
                               "largest response: " +
                                   tone_list(wandering) +
                                   ". No sinusoid removes them. With several channels and three hits of one point, "
                                   "modes near them come from combinations of the channels in which they cancel; "
                                   "otherwise such modes may be missing or false, and their damping is off by more "
                                   "than its ±"},
                              kStopMachine));
  }
  return out;
}

std::vector<Warning> baseline_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                       const HitResponses& responses) {
  std::vector<Warning> out;
  for (std::size_t c = 0; c < record.accel.size(); ++c) {
    double step = 0, slope = 0;
    for (const std::size_t h : accepted_hits(hits)) {
      const auto& change = responses.of[h][c].baseline;
      if (change) (change->step ? step : slope) = std::max(change->step ? step : slope, change->share);
    }
    const std::string name = one_line(record.accel[c].name, kMaxNameBytes);
    if (step > 0) {
      out.push_back(with_remedy(
          {"zero_shift",
           fmt::format("the zero of {} shifts at the hits, by up to {:.2g} % of the largest response: the shock "
                       "overloads the sensor or its amplifier. The decaying step was fitted and removed, but the "
                       "overload also distorts the first motion, which stays",
                       name, 100 * step)},
          "strike more softly, or use a sensor of larger range"));
    }
    if (slope > 0) {
      out.push_back(with_remedy({"offset", fmt::format("the baseline of {} drifts by up to {:.2g} % of the largest "
                                                       "response within a record. A straight slope was fitted and "
                                                       "removed",
                                                       name, 100 * slope)},
                                "let sensor and amplifier warm up, or use AC coupling"));
    }
  }
  return out;
}

std::vector<Warning> window_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                     const HitResponses& responses) {
  std::vector<NoiseHistory> noise;
  std::vector<double> hit_sample;
  double row_s = 0;
  for (const std::size_t h : accepted_hits(hits)) {
    for (const HitResponse& response : responses.of[h]) noise.push_back(response.noise);
    hit_sample.push_back(static_cast<double>(hits[h].hit.peak - hits[h].hit.first));
    row_s = static_cast<double>(hits[h].hit.samples) / record.fs_Hz;
  }
  const auto window = find_recorded_window(noise, median(hit_sample), record.fs_Hz);
  if (!window) return {};
  if (!window->exponential) {
    return {with_remedy(
        {"already_windowed",
         fmt::format("the noise falls to {:.2g} % of its level towards the end, as under a Hann window: the recorder "
                     "windowed the responses. Damping comes out too high and residues wrong, and neither can be "
                     "corrected",
                     100 * window->end_level)},
        "switch the window off and record again")};
  }
  return {with_remedy(
      {"already_windowed",
       fmt::format("the noise decays with {:.4g} ± {:.2g} /s, to {:.2g} % at the end of {:.3g} s: the recorder "
                   "applied an exponential window to the responses. Every damping ratio is too high, by {:.4g} Hz "
                   "divided by the natural frequency of the mode. Every frequency is too high as well, relative to "
                   "itself by this quotient times the mean of the damping ratios with and without the window",
                   window->decay_per_s, window->decay_std_per_s, 100 * window->end_level, row_s,
                   window->decay_per_s / kTwoPi)},
      "subtract these values from the damping ratios and frequencies, or record again without a window")};
}

std::vector<Warning> record_findings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                     const HitResponses& responses) {
  std::vector<Warning> out = fault_warnings(responses.faults, record, hits);
  for (const auto& more : {long_dropout_warnings(record, hits, responses), baseline_warnings(record, hits, responses),
                           tone_warnings(responses.tones), window_warnings(record, hits, responses),
                           analogue_clipping_warnings(record, hits, responses),
                           aliasing_warnings(record, hits, responses), duplicate_warnings(record, hits)})
    out.insert(out.end(), more.begin(), more.end());
  return out;
}

}  // namespace percuss::pipeline
