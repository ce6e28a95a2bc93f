#include "percuss/hits.hpp"

#include "api/handles.hpp"

namespace percuss {
namespace api {

Severity severity_of(warnings::Severity severity) {
  if (severity == warnings::Severity::reject) return Severity::reject;
  return severity == warnings::Severity::warn ? Severity::warn : Severity::info;
}

std::vector<Hit> hits_of(const std::vector<pipeline::AnalysedHit>& hits) {
  std::vector<Hit> out;
  for (const pipeline::AnalysedHit& from : hits) {
    out.push_back({.index = out.size(),
                   .row = from.hit.row,
                   .point = from.point,
                   .onset_s = from.hit.onset_s,
                   .peak_force_N = from.hit.peak_N,
                   .pulse_s = from.hit.pulse_s,
                   .bandwidth_Hz = from.hit.bandwidth_Hz,
                   .accepted = from.accepted,
                   .by_user = from.by_user,
                   .findings = {}});
    for (const acquire::Finding& finding : from.hit.findings) {
      out.back().findings.push_back({.code = name_of(finding.code),
                                     .severity = severity_of(finding.severity),
                                     .value = finding.value,
                                     .message = finding.message,
                                     .options = finding.options,
                                     .delay_s = finding.delay_s});
    }
  }
  return out;
}

}  // namespace api

std::vector<Hit> find_hits(const Record& record, const HitOptions& options) {
  const pipeline::Analysis analysis(api::record_of_one_run(record), api::analysis_options({.hits = options}));
  return api::hits_of(analysis.force_hits());
}

}  // namespace percuss
