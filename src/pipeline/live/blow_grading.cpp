#include "pipeline/live/blow_grading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "acquire/hits/finding.hpp"
#include "core/error.hpp"
#include "core/math/statistics.hpp"
#include "pipeline/analysis.hpp"
#include "pipeline/live/blow_reasons.hpp"

namespace percuss::pipeline {
namespace {

using acquire::RowMark;

constexpr double kMoved = 1e-4;  // of the response
// Plausible limits: the force of a hammer, from pencil-sized to sledge, and the acceleration of a shock accelerometer.
constexpr double kMinForce_N = 0.5, kMaxForce_N = 3e4, kMaxAccel_mps2 = 3e5;

// The rows of the point and, last, the blow.
acquire::Record rows_with_blow(const BlowSamples& samples, const BlowContext& context) {
  acquire::Record record = context.channels.description;
  const std::size_t last = context.rows.size();
  record.rows.assign(last + 1, {.samples = samples.front().size()});
  read_from(context.store, context.rows, record);
  const auto with_last = [&samples, last](auto read, std::size_t row, std::size_t signal, std::size_t first,
                                          std::span<double> out) {
    if (row < last) return read();
    std::copy_n(samples[signal].begin() + static_cast<std::ptrdiff_t>(first), out.size(), out.begin());
  };
  const auto stored_force = record.read_force_N;
  const auto stored_accel = record.read_accel_mps2;
  record.read_force_N = [=](std::size_t row, std::size_t first, std::span<double> out) {
    with_last([&] { stored_force(row, first, out); }, row, 0, first, out);
  };
  record.read_accel_mps2 = [=](std::size_t row, std::size_t c, std::size_t first, std::span<double> out) {
    with_last([&] { stored_accel(row, c, first, out); }, row, c + 1, first, out);
  };
  return record;
}

// The hits of the rows by the analysis; by their force alone where their responses cannot be compared.
std::vector<AnalysedHit> analysed(acquire::Record record, const AnalysisOptions& options) {
  const Analysis analysis(std::move(record), options);
  try {
    return analysis.hits();
  } catch (const InputError&) {
    return analysis.force_hits();
  }
}

// The analysis searches a record of one row for hits. With the blow's own pre-trigger, the hit spans the whole row.
AnalysisOptions options_of(const BlowCircumstances& at, const BlowContext& context) {
  AnalysisOptions options = context.options;
  options.hits.pretrigger_s = static_cast<double>(at.pretrigger) / context.channels.description.fs_Hz;
  return options;
}

// Whether the other blows explain little of this one.
bool is_unlike(const AnalysedHit& hit) {
  return acquire::has_finding(hit.hit.findings, acquire::FindingCode::low_coherence);
}

void note_range(const BlowCircumstances& at, BlowGrade& grade) {
  if (at.range.empty()) return;
  grade.force_range = at.range.front();
  const auto largest = std::max_element(at.range.begin() + 1, at.range.end());
  grade.accel_range = *largest;
  grade.accel_channel = static_cast<std::size_t>(largest - at.range.begin()) - 1;
}

void note_implausible(const BlowSamples& samples, const BlowContext& context, BlowGrade& grade) {
  const double force_N = std::abs(grade.peak_N);
  if (force_N < kMinForce_N || force_N > kMaxForce_N) {
    grade.implausible = fmt::format("{:.3g} N is {} for a hammer: check its sensitivity and unit", force_N,
                                    force_N < kMinForce_N ? "little" : "much");
    return;
  }
  for (std::size_t c = 0; c + 1 < samples.size(); ++c) {
    const double largest_mps2 = extremes_of(samples[c + 1]).max_distance_from(0);
    if (largest_mps2 < kMaxAccel_mps2) continue;
    grade.implausible = fmt::format("{:.3g} m/s² on {} is much: check its sensitivity and unit", largest_mps2,
                                    name_of_channel(context.channels, c));
    return;
  }
}

void note_regraded(const std::vector<AnalysedHit>& hits, const BlowContext& context, BlowGrade& grade) {
  for (const AnalysedHit& hit : hits) {
    if (hit.hit.row < context.rows.size() && !hit.accepted)
      grade.regraded.push_back({.row = context.rows[hit.hit.row], .mark = mark_of(hit)});
  }
}

}  // namespace

BlowGrade grade_blow(const BlowSamples& samples, const BlowCircumstances& circumstances, const BlowContext& context) {
  const acquire::Record own = record_of_blow(context.channels.description, samples);
  const acquire::Hit hit = largest_hit(own, circumstances.pretrigger);
  BlowGrade grade{.peak_N = hit.peak_N, .pulse_s = hit.pulse_s, .bandwidth_Hz = hit.bandwidth_Hz};
  note_range(circumstances, grade);
  note_implausible(samples, context, grade);
  BlowReason reason = judge_capture(samples, circumstances, context);
  if (reason.mark == RowMark::none) reason = judge_dropouts(hit, samples, context);
  if (reason.mark == RowMark::none) reason = judge_range(circumstances, context);
  if (reason.mark == RowMark::none) reason = judge_force(hit, circumstances, context);
  if (reason.mark == RowMark::none) {
    const std::vector<AnalysedHit> hits =
        analysed(rows_with_blow(samples, context), options_of(circumstances, context));
    const auto blow = std::find_if(hits.rbegin(), hits.rend(),
                                   [&](const AnalysedHit& h) { return h.hit.row == context.rows.size(); });
    if (blow != hits.rend()) {
      reason = judge_responses(*blow, circumstances, context);
      const double motion = motion_before(samples, circumstances);
      if (reason.mark == RowMark::none) reason = judge_motion(motion, circumstances);
      grade.moved_before = motion > kMoved;
      grade.unlike_others = is_unlike(*blow);
      grade.blows_differ = std::any_of(hits.begin(), hits.end(),
                                       [](const AnalysedHit& other) { return other.accepted && is_unlike(other); });
      grade.rings_at_end = std::any_of(blow->responses.begin(), blow->responses.end(),
                                       [](const acquire::ResponseGrade& response) { return response.truncated; });
    }
    if (reason.mark == RowMark::none || reason.mark == RowMark::force_overload) note_regraded(hits, context, grade);
  }
  grade.mark = reason.mark;
  grade.reason = std::move(reason.reason);
  grade.remedy = std::move(reason.remedy);
  return grade;
}

}  // namespace percuss::pipeline
