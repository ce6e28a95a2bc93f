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

// Samples: a long rest before a hit, as in a record of several blows, shows a weak motion that a pre-trigger hides.
constexpr std::size_t kMinLongRest = 1024, kLongRest = 8192;
constexpr std::size_t kFilterBeforePulse = 72;  // samples, in which a filter of linear phase rings before the pulse
constexpr double kMoreThanNoise = 1.3;          // power over that of white noise; 1024 samples give it to 5 %
constexpr double kMotion = 3e-4;                // of the largest response

// The samples before a hit, after the last blow in its row.
acquire::SampleRange rest_before(const std::vector<AnalysedHit>& impacts, std::size_t h) {
  const acquire::Hit& hit = impacts[h].hit;
  const std::size_t end = hit.gate_first - std::min(hit.gate_first, kFilterBeforePulse);
  std::size_t first = end - std::min(end, kLongRest);
  for (const AnalysedHit& other : impacts) {
    if (other.hit.row == hit.row && other.hit.peak < hit.peak)
      first = std::max(first, std::min(end, other.hit.tail_end));
  }
  return {first, end};
}

bool holds_motion(std::span<const double> rest, double largest) {
  const double white = std::pow(difference_rms(rest).value_or(0), 2), all = std::pow(rms_about_mean(rest), 2);
  return all > kMoreThanNoise * white && std::sqrt(all - white) > kMotion * largest;
}

}  // namespace

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
