#include "pipeline/warnings/role_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "acquire/channels/role_guess.hpp"
#include "core/error.hpp"

namespace percuss::pipeline {
namespace {

bool lacks_pulse(const AnalysedHit& hit) {
  const auto& findings = hit.hit.findings;
  return !hit.accepted && !hit.by_user && std::any_of(findings.begin(), findings.end(), [](const auto& finding) {
    return finding.code == acquire::FindingCode::no_pulse;
  });
}

}  // namespace

std::vector<Warning> role_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits) {
  if (!record.has_force || hits.empty() || !std::all_of(hits.begin(), hits.end(), lacks_pulse)) return {};
  const std::size_t row = hits.front().hit.row;
  std::vector<double> samples(std::min(record.rows[row].samples, acquire::kGuessedSamples));
  record.read_force_N(row, 0, samples);
  const double force_measure = acquire::hammer_dissimilarity(samples);
  std::size_t hammer = 0;
  double smallest = 1;
  for (std::size_t c = 0; c < record.accel.size(); ++c) {
    record.read_accel_mps2(row, c, 0, samples);
    const double measure = acquire::hammer_dissimilarity(samples);
    if (measure < smallest) {
      smallest = measure;
      hammer = c;
    }
  }
  if (!(acquire::kMaxDissimilarityRatio * smallest < force_measure)) return {};
  const std::string force = one_line(record.force.name, kMaxNameBytes);
  const std::string response = one_line(record.accel[hammer].name, kMaxNameBytes);
  return {with_remedy(
      {"swapped_channels",
       fmt::format("{} looks like the hammer and {} like a response: the channels are swapped", response, force),
       {"force_channel", "accel_channel"}},
      fmt::format("name {} as the force and {} as the acceleration, and their units if the file states others",
                  response, force))};
}

}  // namespace percuss::pipeline
