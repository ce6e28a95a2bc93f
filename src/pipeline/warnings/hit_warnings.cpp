#include "pipeline/warnings/hit_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace percuss::pipeline {
namespace {

constexpr double kPoorCoherence = 0.5;

bool any_accepted_with(const std::vector<AnalysedHit>& hits, acquire::FindingCode code) {
  return std::any_of(hits.begin(), hits.end(), [&](const AnalysedHit& hit) {
    return hit.accepted && std::any_of(hit.hit.findings.begin(), hit.hit.findings.end(),
                                       [&](const acquire::Finding& finding) { return finding.code == code; });
  });
}

// "hits 0, 2": accepted hits whose coherence with the others is poor; empty when there are none.
std::string poorly_coherent_hits(const std::vector<AnalysedHit>& hits) {
  std::string out;
  for (const std::size_t h : accepted_hits(hits)) {
    const auto& findings = hits[h].hit.findings;
    const bool poor = std::any_of(findings.begin(), findings.end(), [](const acquire::Finding& finding) {
      return finding.code == acquire::FindingCode::low_coherence && finding.value < kPoorCoherence;
    });
    if (poor) out += fmt::format("{}{}", out.empty() ? "hits " : ", ", h);
  }
  return out;
}

Warning disagreement(const std::string& hits, bool several_files) {
  Warning warning{"hits_disagree", hits +
                                       " explain less than half of the other hits' response: was another structure, "
                                       "point or sensor measured? The modes are those of a mixture"};
  if (!several_files) return with_remedy(std::move(warning), "analyse the hits of each structure and point apart");
  warning.options = {"files"};
  return with_remedy(std::move(warning), "analyse each file as a test of its own");
}

}  // namespace

std::vector<Warning> hit_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits) {
  std::vector<Warning> out;
  const std::size_t rejected = hits.size() - accepted_hits(hits).size();
  if (rejected > 0) {
    out.push_back({"rejected_hits",
                   fmt::format("{} of {} hits not used; each hit's verdict gives the reason", rejected, hits.size())});
  }
  if (const std::string poor = poorly_coherent_hits(hits); !poor.empty())
    out.push_back(disagreement(poor, record.files.size() > 1));
  if (any_accepted_with(hits, acquire::FindingCode::polarity)) {
    out.push_back(with_remedy({"polarity",
                               "the force is negative during the pulse: the FRFs have the wrong sign unless the force "
                               "is scaled by a negative factor",
                               {"force_scale"}},
                              "state a negative scale of the force"));
  }
  if (any_accepted_with(hits, acquire::FindingCode::low_bandwidth)) {
    out.push_back(with_remedy(
        {"low_bandwidth", "the hammer's force does not reach the end of the band: modes there are weakly excited"},
        "use a harder tip or a lighter hammer"));
  }
  return out;
}

std::vector<Warning> rest_warnings(const std::vector<AnalysedHit>& hits) {
  const bool rings = std::any_of(hits.begin(), hits.end(), [](const AnalysedHit& hit) {
    return hit.accepted && std::any_of(hit.responses.begin(), hit.responses.end(),
                                       [](const acquire::ResponseGrade& grade) { return grade.rings_before; });
  });
  if (!rings) return {};
  return {with_remedy(
      {"not_at_rest", "the structure was still ringing before a hit: the damping may be off by more than its ±"},
      "wait longer between hits")};
}

}  // namespace percuss::pipeline
