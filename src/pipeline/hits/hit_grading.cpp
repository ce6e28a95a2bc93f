#include "pipeline/hits/hit_grading.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "pipeline/hits/hit_gaps.hpp"
#include "pipeline/hits/needed_hits.hpp"
#include "pipeline/hits/response_clipping.hpp"

namespace percuss::pipeline {
namespace {

bool contains(const std::vector<std::size_t>& list, std::size_t i) {
  return std::find(list.begin(), list.end(), i) != list.end();
}

}  // namespace

bool names_hit(const std::vector<std::size_t>& list, const std::vector<std::size_t>& other, std::size_t i) {
  return contains(list, i) || (contains(list, kEveryHit) && !contains(other, i));
}

void require_hits(const std::vector<std::size_t>& indices, std::size_t hits, const acquire::Record& record,
                  const char* option) {
  for (const std::size_t i : indices) {
    if (i < hits || i == kEveryHit) continue;
    throw InputError(fmt::format("there is no hit {} among {} hits", i + 1, hits), record.source(),
                     "hits count from 1, as in the table of hits", {option});
  }
}

std::vector<AnalysedHit> grade_by_force(std::vector<acquire::Hit> found, const acquire::Record& record,
                                        const HitDemands& demands) {
  require_hits(demands.accept, found.size(), record, "accept_hit");
  require_hits(demands.reject, found.size(), record, "reject_hit");
  if (demands.high_Hz) acquire::grade_bandwidth(found, *demands.high_Hz);
  grade_gaps(found, record);
  std::vector<AnalysedHit> hits;
  hits.reserve(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    AnalysedHit hit{.hit = std::move(found[i]), .responses = {}};
    const bool accept = names_hit(demands.accept, demands.reject, i) && can_be_accepted(hit);
    const bool reject = names_hit(demands.reject, demands.accept, i);
    hit.by_user = accept || reject;
    hit.point = record.rows[hit.hit.row].point;
    hit.accepted = accept || (!reject && !acquire::rejects(hit.hit.findings));
    hits.push_back(std::move(hit));
  }
  accept_needed_hits(hits, record.fs_Hz);
  return hits;
}

void grade_by_responses(std::vector<AnalysedHit>& hits, const HitResponses& responses) {
  for (std::size_t h = 0; h < hits.size(); ++h) {
    for (const HitResponse& response : responses.of[h]) hits[h].responses.push_back(response.grade);
  }
  grade_repeated_clipping(hits);
  for (AnalysedHit& hit : hits) {
    acquire::add_response_findings(hit.hit, hit.responses);
    if (!hit.by_user) hit.accepted = hit.accepted && !acquire::rejects(hit.hit.findings);
  }
}

}  // namespace percuss::pipeline
