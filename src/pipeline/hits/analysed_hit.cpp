#include "pipeline/hits/analysed_hit.hpp"

#include <algorithm>

namespace percuss::pipeline {

std::vector<std::size_t> accepted_hits(const std::vector<AnalysedHit>& hits) {
  std::vector<std::size_t> accepted;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    if (hits[h].accepted) accepted.push_back(h);
  }
  return accepted;
}

bool any_accepted(const std::vector<AnalysedHit>& hits) {
  return std::any_of(hits.begin(), hits.end(), [](const AnalysedHit& hit) { return hit.accepted; });
}

bool lacks_samples_of_pulse(const AnalysedHit& hit) {
  return std::any_of(hit.hit.findings.begin(), hit.hit.findings.end(), [](const acquire::Finding& finding) {
    return finding.code == acquire::FindingCode::lost_samples && !finding.delay_s;
  });
}

bool can_accept_more(const std::vector<AnalysedHit>& hits) {
  return std::any_of(hits.begin(), hits.end(), [](const AnalysedHit& hit) {
    return !hit.accepted && can_be_accepted(hit) && !lacks_samples_of_pulse(hit);
  });
}

}  // namespace percuss::pipeline
