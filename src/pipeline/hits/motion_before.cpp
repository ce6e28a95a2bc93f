#include "pipeline/hits/motion_before.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "acquire/hits/time_selection.hpp"
#include "core/math/statistics.hpp"
#include "core/parallel/parallel.hpp"
#include "pipeline/findings/difference_profile.hpp"

namespace percuss::pipeline {
namespace {

// Samples. A short pre-trigger does not show a weak motion; a long rest before a hit does, as in a record of several
// blows.
constexpr std::size_t kMinLongRest = 1024, kLongRest = 8192;
constexpr double kMoreThanNoise = 1.3;  // power over white noise's: for white noise of 1024 samples, 1 ± 8 %
constexpr double kMotion = 3e-4;        // of the largest response

std::size_t end_of_force(const acquire::Hit& hit) {
  return std::max({hit.gate_first + hit.gated_N.size(), hit.pulse_end, hit.tail_end});
}

// The samples before a hit, after the last blow in its row.
acquire::SampleRange rest_before(const std::vector<AnalysedHit>& impacts, std::size_t h) {
  const acquire::Hit& hit = impacts[h].hit;
  const std::size_t end = hit.gate_first - std::min(hit.gate_first, kFilterBeforePulse);
  return {std::max(end - std::min(end, kLongRest), std::min(end, last_blow_before(impacts, h).end)), end};
}

bool holds_motion(std::span<const double> rest, double largest) {
  const double white = std::pow(difference_rms(rest).value_or(0), 2), all = std::pow(rms_about_mean(rest), 2);
  return all > kMoreThanNoise * white && std::sqrt(all - white) > kMotion * largest;
}

}  // namespace

LastBlow last_blow_before(const std::vector<AnalysedHit>& hits, std::size_t hit) {
  LastBlow last;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    const acquire::Hit& other = hits[h].hit;
    if (other.row != hits[hit].hit.row || other.peak >= hits[hit].hit.peak || other.gated_N.empty()) continue;
    if (!last.hit || other.peak > hits[*last.hit].hit.peak) last.hit = h;
    last.end = std::max(last.end, end_of_force(other));
  }
  return last;
}

bool may_ring_before(const AnalysedHit& hit) {
  return std::any_of(hit.responses.begin(), hit.responses.end(),
                     [](const acquire::ResponseGrade& grade) { return grade.may_ring_before; });
}

std::vector<bool> moves_before(const acquire::Record& record, const std::vector<AnalysedHit>& impacts,
                               const std::vector<std::size_t>& hits, std::size_t threads) {
  std::vector<char> moves(hits.size());  // not bool: several threads write
  parallel_for(hits.size(), threads, [&](std::size_t i) {
    const acquire::Hit& hit = impacts[hits[i]].hit;
    if (hit.gated_N.empty()) return;
    const auto [first, end] = rest_before(impacts, hits[i]);
    std::vector<double> buffer;
    for (std::size_t c = 0; c < record.accel.size() && moves[i] == 0; ++c) {
      const auto accel = record.read_accel_mps2.view_or_read(hit.row, c, hit.first, hit.samples, buffer);
      const acquire::ResponseGrade grade = acquire::grade_response(hit, accel, record.fs_Hz);
      bool found = grade.may_ring_before;
      if (!found && end - first >= kMinLongRest) {
        const auto rest = record.read_accel_mps2.view_or_read(hit.row, c, first, end - first, buffer);
        found = holds_motion(rest, grade.extremes.max_distance_from(0));
      }
      moves[i] = found ? 1 : 0;
    }
  });
  return {moves.begin(), moves.end()};
}

}  // namespace percuss::pipeline
