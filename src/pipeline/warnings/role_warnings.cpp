#include "pipeline/warnings/role_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "acquire/channels/role_guess.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace percuss::pipeline {
namespace {

bool lacks_pulse(const AnalysedHit& hit) {
  const auto& findings = hit.hit.findings;
  return !hit.accepted && !hit.by_user && std::any_of(findings.begin(), findings.end(), [](const auto& finding) {
    return finding.code == acquire::FindingCode::no_pulse;
  });
}

bool states_unit(const acquire::SignalInfo& signal, Quantity quantity) {
  const auto unit = parse_unit(signal.unit);
  return !signal.unit_assumed && unit && unit->quantity == quantity;
}

// "force and accel 2": the accelerations once the hammer and the force have changed places.
std::string accelerations_without(const acquire::Record& record, std::size_t hammer) {
  constexpr std::size_t kListed = 6;
  const std::string force = one_line(record.force.name, kMaxNameBytes);
  if (record.accel.size() > kListed) return force + " in its place among the accelerations";
  std::string list;
  for (std::size_t c = 0; c < record.accel.size(); ++c) {
    const char* const between = c == 0 ? "" : c + 1 == record.accel.size() ? " and " : ", ";
    list += between + (c == hammer ? force : one_line(record.accel[c].name, kMaxNameBytes));
  }
  return list + (record.accel.size() == 1 ? " as the acceleration" : " as the accelerations");
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
  Warning warning{
      "swapped_channels",
      fmt::format("{} looks like the hammer and {} like a response: the channels are swapped", response, force),
      {"force_channel", "accel_channel"}};
  std::string remedy = fmt::format("name {} as the force, and {}", response, accelerations_without(record, hammer));
  // The file's units are those of the roles that it states; the reader refuses them for the others.
  if (states_unit(record.force, Quantity::force) || states_unit(record.accel[hammer], Quantity::acceleration)) {
    warning.options.insert(warning.options.end(), {"force_unit", "unit"});
    remedy += "; state the units, too, because those of the file belong to its own roles";
  }
  return {with_remedy(std::move(warning), remedy)};
}

}  // namespace percuss::pipeline
