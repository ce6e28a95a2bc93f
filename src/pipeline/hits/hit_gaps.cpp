#include "pipeline/hits/hit_gaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace percuss::pipeline {
namespace {

constexpr std::size_t kBesidePulse = 16;  // samples on either side of the pulse: the recorder's filter rings there
constexpr double kMinKept = 0.8;          // of the samples: a shorter hit would shorten the FRFs of all hits

// The sample of the row after the pulse and the ringing beside it.
std::size_t end_of_ringing(const acquire::Hit& hit) { return hit.gate_first + hit.gated_N.size() + kBesidePulse; }

std::size_t end_of_gap(const acquire::SampleGap& gap) { return gap.first + gap.count; }

// The gaps of the row from the pulse of a hit to the end of the hit, each with the decay between the gaps beside it.
std::vector<GapInDecay> gaps_from_pulse_on(const acquire::Hit& hit, const std::vector<acquire::SampleGap>& gaps) {
  std::vector<GapInDecay> out;
  if (hit.gated_N.empty()) return out;
  const std::size_t end = hit.first + hit.samples;
  for (const acquire::SampleGap& gap : gaps) {
    if (gap.row != hit.row || gap.first >= end || end_of_gap(gap) + kBesidePulse <= hit.gate_first) continue;
    const std::size_t after = out.empty() ? 0 : end_of_gap(out.back().gap);
    if (!out.empty()) out.back().decay.end = gap.first;
    out.push_back({.gap = gap, .decay = {.first = std::max(end_of_ringing(hit), after), .end = end}});
  }
  return out;
}

bool touches_pulse(const GapInDecay& at, const acquire::Hit& hit) { return at.gap.first < end_of_ringing(hit); }

acquire::Finding finding_of(const GapInDecay& at, acquire::Severity severity, std::string message) {
  return {.code = acquire::FindingCode::lost_samples,
          .severity = severity,
          .value = static_cast<double>(at.gap.count),
          .message = std::move(message)};
}

}  // namespace

void grade_gaps(std::vector<acquire::Hit>& hits, const acquire::Record& record) {
  const std::vector<acquire::SampleGap> gaps = acquire::gaps_of(record);
  for (acquire::Hit& hit : hits) {
    for (const GapInDecay& at : gaps_from_pulse_on(hit, gaps)) {
      const std::string missing = samples_text(at.gap.count) + (at.gap.count == 1 ? " is" : " are") + " missing";
      if (touches_pulse(at, hit)) {
        hit.findings.push_back(
            finding_of(at, acquire::Severity::reject, missing + " within the pulse or just beside it; repeat the hit"));
        continue;
      }
      if (can_predict(at)) continue;
      const std::size_t kept = at.gap.first - hit.first;
      const bool rejects = static_cast<double>(kept) < kMinKept * static_cast<double>(hit.samples);
      const double after_s = static_cast<double>(at.gap.first - hit.peak) / record.fs_Hz;
      hit.findings.push_back(
          finding_of(at, rejects ? acquire::Severity::reject : acquire::Severity::warn,
                     fmt::format("{} {:.4g} ms after the blow and cannot be predicted; the hit ends before them",
                                 missing, after_s * 1e3)));
      hit.findings.back().delay_s = after_s;
      hit.samples = kept;
      break;
    }
  }
}

std::vector<HitGap> predictable_gaps(const std::vector<AnalysedHit>& hits, const acquire::Record& record) {
  std::vector<HitGap> out;
  const std::vector<acquire::SampleGap> gaps = acquire::gaps_of(record);
  for (const std::size_t h : accepted_hits(hits)) {
    for (const GapInDecay& at : gaps_from_pulse_on(hits[h].hit, gaps)) {
      if (!touches_pulse(at, hits[h].hit) && can_predict(at)) out.push_back({h, at});
    }
  }
  return out;
}

ClosedGaps close_gaps(const acquire::Record& record, const std::vector<AnalysedHit>& hits) {
  ClosedGaps out{.record = {}, .gaps = predictable_gaps(hits, record), .failed = {}};
  std::vector<GapInDecay> places;
  for (const HitGap& gap : out.gaps) places.push_back(gap.at);
  out.record = with_predicted_samples(record, places, out.failed);
  return out;
}

}  // namespace percuss::pipeline
