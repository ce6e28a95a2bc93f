#include "pipeline/hits/needed_hits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

namespace percuss::pipeline {
namespace {

using acquire::Finding, acquire::FindingCode, acquire::Severity;

// Second contact over the main pulse. A larger contact is another hit, and more may follow; the spectrum of two equal
// contacts has zeros.
constexpr double kMaxUsableRatio = 0.5;
constexpr std::size_t kEnoughHits = 2;  // accepted hits of a point: two can be compared with each other

// Whether the gate includes the second contact, and this contact is no hit of its own. The gate leaves out spikes, and
// contacts before the samples of the hit.
bool holds_second_contact(const acquire::Hit& hit, const Finding& finding, double fs_Hz) {
  if (finding.code == FindingCode::double_hit && finding.value > kMaxUsableRatio) return false;
  const double delay = std::floor(finding.delay_s.value_or(0) * fs_Hz), peak = static_cast<double>(hit.peak);
  const auto first = static_cast<double>(hit.gate_first);
  return finding.before_main ? first + delay <= peak : first + static_cast<double>(hit.gated_N.size()) >= peak + delay;
}

// Whether the hit was rejected for these reasons alone, and its gate holds the whole force.
bool usable_in_spite_of(const AnalysedHit& hit, std::span<const FindingCode> reasons, double fs_Hz) {
  if (hit.accepted || hit.by_user || hit.hit.gated_N.empty()) return false;
  return std::all_of(hit.hit.findings.begin(), hit.hit.findings.end(), [&](const Finding& finding) {
    return finding.severity != Severity::reject ||
           (std::find(reasons.begin(), reasons.end(), finding.code) != reasons.end() &&
            holds_second_contact(hit.hit, finding, fs_Hz));
  });
}

void accept_with_warning(AnalysedHit& hit) {
  hit.accepted = true;
  for (Finding& finding : hit.hit.findings) {
    if (finding.severity != Severity::reject) continue;
    finding.severity = Severity::warn;
    finding.message += finding.code == FindingCode::double_hit
                           ? "; used, because its point has too few other hits and the force holds both contacts"
                           : "; used, because its point has too few other hits: frequencies and damping hold, "
                             "amplitudes do not";
  }
}

void accept_at_point(std::vector<AnalysedHit>& hits, const std::vector<std::size_t>& members, double fs_Hz) {
  constexpr std::array kReasons{FindingCode::double_hit, FindingCode::force_clipped};
  for (const std::size_t reasons : {1U, 2U}) {
    const auto used = std::count_if(members.begin(), members.end(), [&](std::size_t h) { return hits[h].accepted; });
    if (static_cast<std::size_t>(used) >= kEnoughHits) return;
    for (const std::size_t h : members) {
      if (usable_in_spite_of(hits[h], std::span(kReasons).first(reasons), fs_Hz)) accept_with_warning(hits[h]);
    }
  }
}

}  // namespace

void accept_needed_hits(std::vector<AnalysedHit>& hits, double fs_Hz) {
  std::map<int, std::vector<std::size_t>> points;
  for (std::size_t h = 0; h < hits.size(); ++h) points[hits[h].point].push_back(h);
  for (const auto& [point, members] : points) accept_at_point(hits, members, fs_Hz);
}

}  // namespace percuss::pipeline
