#include "pipeline/impacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "acquire/hits/finding.hpp"
#include "acquire/hits/pulse_shape.hpp"
#include "acquire/hits/response_grade.hpp"
#include "acquire/hits/time_selection.hpp"
#include "core/error.hpp"
#include "core/parallel/parallel.hpp"
#include "metrics/deflection/deflection.hpp"
#include "pipeline/hits/hit_grading.hpp"
#include "pipeline/hits/motion_before.hpp"
#include "pipeline/hits/responding_channel.hpp"
#include "pipeline/hits/response_clipping.hpp"
#include "pipeline/impact_speed.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {
namespace {

// Fewest samples before the onset that allow an estimate of the bias despite the ringing of the filter.
constexpr std::size_t kMinRestSamples = 16;
// The rest before an impact gives the bias of the acceleration, whose double integral grows with the square of the
// time. A longer rest may hold a drift that is no straight line.
constexpr double kRest_s = 0.1;

// The samples of an impact before its pulse, or before the motion where no pulse is known.
std::size_t samples_before(const acquire::Hit& hit, double fs_Hz) {
  if (!hit.gated_N.empty()) return hit.gate_first - std::min(hit.gate_first, hit.first);
  return static_cast<std::size_t>(onset_from_first_sample_s(hit, fs_Hz) * fs_Hz);
}

// Whether the force of a hit has no pulse and is not larger than noise: hits.cpp states the ratio of both.
bool shows_noise_alone(const AnalysedHit& hit) {
  return hit.hit.gated_N.empty() && std::any_of(hit.hit.findings.begin(), hit.hit.findings.end(), [](const auto& one) {
           return one.code == acquire::FindingCode::no_pulse && one.value <= acquire::kPulseToNoise;
         });
}

}  // namespace

bool is_usable_impact(const AnalysedHit& hit, const AnalysisOptions& options, std::size_t index) {
  if (names_hit(options.reject_hits, options.accept_hits, index)) return false;
  const bool lacks_samples = std::any_of(hit.hit.findings.begin(), hit.hit.findings.end(), [](const auto& finding) {
    return finding.code == acquire::FindingCode::lost_samples && finding.severity == acquire::Severity::reject;
  });
  return names_hit(options.accept_hits, options.reject_hits, index) ||
         !(lacks_samples || acquire::has_finding(hit.hit.findings, acquire::FindingCode::no_pulse));
}

std::size_t impacts_without_pulse(const std::vector<AnalysedHit>& impacts, const AnalysisOptions& options) {
  std::size_t count = 0;
  for (std::size_t h = 0; h < impacts.size(); ++h) {
    const bool lacks_pulse = acquire::has_finding(impacts[h].hit.findings, acquire::FindingCode::no_pulse);
    if (lacks_pulse && !is_usable_impact(impacts[h], options, h) &&
        !names_hit(options.reject_hits, options.accept_hits, h))
      ++count;
  }
  return count;
}

std::vector<std::size_t> clipped_samples_of(const acquire::Record& record, std::vector<AnalysedHit> impacts,
                                            std::size_t threads) {
  const std::size_t channels = record.accel.size();
  for (AnalysedHit& impact : impacts) impact.responses.assign(channels, {});
  parallel_for(impacts.size() * channels, threads, [&](std::size_t i) {
    AnalysedHit& impact = impacts[i / channels];
    std::vector<double> accel(impact.hit.samples);
    record.read_accel_mps2(impact.hit.row, i % channels, impact.hit.first, accel);
    impact.responses[i % channels] = acquire::grade_clipping(accel, samples_before(impact.hit, record.fs_Hz));
  });
  grade_repeated_clipping(impacts);
  std::vector<std::size_t> clipped;
  for (const AnalysedHit& impact : impacts) {
    clipped.push_back(0);
    for (const acquire::ResponseGrade& grade : impact.responses)
      clipped.back() = std::max(clipped.back(), grade.clipped_samples);
  }
  return clipped;
}

std::optional<acquire::Record> record_without_idle_force(const Analysis& analysis) {
  if (analysis.given_frfs() != nullptr || !analysis.record().has_force || analysis.options().hits.trigger_N)
    return std::nullopt;
  const std::vector<AnalysedHit>& hits = analysis.force_hits();
  if (!std::all_of(hits.begin(), hits.end(), shows_noise_alone)) return std::nullopt;
  std::optional<std::size_t> moving;
  for (std::size_t h = 0; h < hits.size() && !moving; ++h)
    moving = responding_channel(analysis.closed_gaps().record, hits[h].hit);
  if (!moving) return std::nullopt;
  acquire::Record out = analysis.record();
  out.has_force = false;
  out.read_force_N = acquire::no_force();
  out.contiguous.clear();
  out.notes.push_back(information(fmt::format(
      "{} stays in its noise, while {} responds: the deflections follow from the accelerations alone, as without a "
      "force. If a hammer struck, check its cable",
      one_line(out.force.name, kMaxNameBytes), one_line(out.accel[*moving].name, kMaxNameBytes))));
  return out;
}

std::vector<AnalysedHit> impacts_without_force(const acquire::Record& record) {
  std::vector<AnalysedHit> impacts;
  impacts.reserve(record.rows.size());
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    std::vector<double> accel(record.rows[row].samples);
    double onset_s = static_cast<double>(accel.size()) / record.fs_Hz;
    for (std::size_t c = 0; c < record.accel.size(); ++c) {
      record.read_accel_mps2(row, c, 0, accel);
      onset_s = std::min(onset_s, metrics::motion_onset_s(accel, record.fs_Hz));
    }
    AnalysedHit impact{.point = record.rows[row].point, .accepted = true, .responses = {}};
    impact.hit.row = row;
    impact.hit.samples = accel.size();
    impact.hit.onset_s = onset_s;
    impacts.push_back(std::move(impact));
  }
  return impacts;
}

std::size_t first_sample_of_impact(const acquire::Record& record, const acquire::HitOptions& options,
                                   const std::vector<AnalysedHit>& impacts, std::size_t h) {
  const acquire::Hit& hit = impacts[h].hit;
  if (options.pretrigger_s) return hit.first;
  const auto rest = static_cast<std::size_t>(kRest_s * record.fs_Hz);
  const std::size_t earliest =
      std::max(last_blow_before(impacts, h).end, acquire::select_time_range(record, hit.row, options).first);
  return std::min(hit.first, std::max(earliest, hit.gate_first - std::min(hit.gate_first, rest)));
}

bool rest_recorded(double fs_Hz, const std::vector<AnalysedHit>& impacts, const std::vector<std::size_t>& hits) {
  return std::all_of(hits.begin(), hits.end(), [&](std::size_t h) {
    return onset_from_first_sample_s(impacts[h].hit, fs_Hz) * fs_Hz >= static_cast<double>(kMinRestSamples);
  });
}

}  // namespace percuss::pipeline
