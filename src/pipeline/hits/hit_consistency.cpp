#include "pipeline/hits/hit_consistency.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "core/math/statistics.hpp"
#include "core/parallel/parallel.hpp"
#include "frf/leave_one_out.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kOutlierRatio = 25;           // outlier's error over the others' median (five times in amplitude)
constexpr double kOutlierEnergy = 0.05;        // least error of an outlier, of its energy: smaller errors are harmless
constexpr std::size_t kMaxHitsToCompare = 30;  // of a point: odd_one compares the other hits once per hit
constexpr std::size_t kFlopsPerHit = 50'000;
constexpr double kLowCoherence = 0.9;
constexpr double kMaxDissent = 0.2;  // of the hits: above it the direction of the first motion is undecided

std::vector<std::size_t> without(std::vector<std::size_t> members, std::size_t i) {
  members.erase(members.begin() + static_cast<std::ptrdiff_t>(i));
  return members;
}

// The fraction of each member's response that the others do not explain; empty for a single hit.
std::vector<double> unexplained(const std::vector<ComparedHit>& spectra, const std::vector<std::size_t>& members) {
  std::vector<std::span<const Complex>> force;
  std::vector<std::vector<std::span<const Complex>>> accel;
  for (const std::size_t h : members) {
    force.push_back(spectra[h].force);
    accel.push_back(spectra[h].accel);
  }
  return frf::leave_one_out_error(force, accel);
}

void reject_outlier(AnalysedHit& hit, double error, double typical) {
  hit.hit.findings.push_back(
      {.code = acquire::FindingCode::outlier,
       .severity = acquire::Severity::reject,
       .value = error,
       .message = fmt::format(
           "outlier: the FRFs of the other hits leave {:.0f} % of its response unexplained, but {} of their "
           "own responses",
           error * 100, typical < 5e-4 ? "less than 0.1 %" : fmt::format("{:.1f} %", typical * 100))});
  if (!hit.by_user) hit.accepted = false;
}

std::string disagreement(double explained, const char* others) {
  const std::string how_far = explained > 0 ? fmt::format("explain only {:.0f} % of its response", explained * 100)
                                            : "do not explain its response at all";
  return others + how_far + ": did the point or the direction change?";
}

bool is_outlier(double error, double typical) { return error > std::max(kOutlierRatio * typical, kOutlierEnergy); }

// The member without which the others agree best. A strong wrong hit dominates the FRFs that explain the
// others, so that the largest error may belong to another hit.
std::size_t odd_one(const std::vector<ComparedHit>& spectra, const std::vector<std::size_t>& members) {
  std::size_t odd = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < members.size(); ++i) {
    const std::vector<double> left = unexplained(spectra, without(members, i));
    const double sum = std::accumulate(left.begin(), left.end(), 0.0);
    if (sum < least) odd = i;
    least = std::min(least, sum);
  }
  return odd;
}

// Of three hits, the one that the other two contradict while they agree with each other; nothing where no two agree.
// Two wrong hits may agree, so the third is named and not rejected. `errors` become those of the pair.
std::optional<std::size_t> odd_of_three(const std::vector<ComparedHit>& spectra,
                                        const std::vector<std::size_t>& members, std::vector<double>& errors) {
  if (members.size() != 3 || *std::max_element(errors.begin(), errors.end()) <= kOutlierEnergy) return std::nullopt;
  const std::size_t odd = odd_one(spectra, members);
  const std::vector<double> pair = unexplained(spectra, without(members, odd));
  if (!is_outlier(errors[odd], *std::max_element(pair.begin(), pair.end()))) return std::nullopt;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (i != odd) errors[i] = pair[i < odd ? i : i - 1];
  }
  return odd;
}

void grade_point(std::vector<AnalysedHit>& hits, const std::vector<ComparedHit>& spectra,
                 std::vector<std::size_t> members, const std::vector<acquire::RowInfo>& rows) {
  std::vector<double> errors = unexplained(spectra, members);
  while (members.size() >= kMinHitsToFindOutlier) {
    const auto worst = static_cast<std::size_t>(std::max_element(errors.begin(), errors.end()) - errors.begin());
    if (errors[worst] <= kOutlierEnergy) break;
    // A wrong hit distorts the FRFs that explain the others: their errors are computed without it.
    const auto try_out = [&](std::size_t i) {
      std::vector<std::size_t> others = without(members, i);
      std::vector<double> among_others = unexplained(spectra, others);
      const double typical = median(among_others);
      if (!is_outlier(errors[i], typical)) return false;
      reject_outlier(hits[members[i]], errors[i], typical);
      members = std::move(others);
      errors = std::move(among_others);
      return true;
    };
    if (try_out(worst)) continue;
    if (members.size() > kMaxHitsToCompare || !try_out(odd_one(spectra, members))) break;
  }
  const std::optional<std::size_t> odd = odd_of_three(spectra, members, errors);
  const bool any_low = std::any_of(errors.begin(), errors.end(), [](double e) { return 1 - e < kLowCoherence; });
  const bool several_tests = any_low && may_be_several_tests(rows, hits, members);
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (1 - errors[i] >= kLowCoherence) continue;
    const char* others = odd == i ? "the other two hits agree with each other and " : "the other hits ";
    hits[members[i]].hit.findings.push_back({.code = acquire::FindingCode::low_coherence,
                                             .severity = acquire::Severity::warn,
                                             .value = 1 - errors[i],
                                             .message = disagreement(1 - errors[i], others),
                                             .options = {several_tests ? "files" : "reject_hit"}});
  }
}

}  // namespace

std::vector<ComparedHit> spectra_of_hits(const std::vector<AnalysedHit>& hits, const std::vector<frf::Spectrum>& force,
                                         const HitResponses& responses, std::size_t lines) {
  std::vector<ComparedHit> spectra(hits.size());
  for (const std::size_t h : accepted_hits(hits)) {
    spectra[h].force = {force[h].get(), lines};
    for (const HitResponse& response : responses.of[h]) spectra[h].accel.push_back(response.spectrum);
  }
  return spectra;
}

bool may_be_several_tests(const std::vector<acquire::RowInfo>& rows, const std::vector<AnalysedHit>& hits,
                          const std::vector<std::size_t>& of_point) {
  std::set<std::size_t> files;
  for (const std::size_t h : of_point) {
    if (hits[h].hit.row < rows.size()) files.insert(rows[hits[h].hit.row].file);
  }
  if (files.size() < 2) return false;
  std::set<int> points, points_of_files;
  for (const acquire::RowInfo& row : rows) {
    points.insert(row.point);
    if (files.contains(row.file)) points_of_files.insert(row.point);
  }
  return points.size() == 1 || points_of_files.size() > 1;
}

void grade_agreement(std::vector<AnalysedHit>& hits, const std::vector<ComparedHit>& spectra,
                     const std::vector<acquire::RowInfo>& rows) {
  std::map<int, std::vector<std::size_t>> points;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    if (hits[h].accepted && !spectra[h].force.empty()) points[hits[h].point].push_back(h);
  }
  std::vector<std::vector<std::size_t>> groups;
  groups.reserve(points.size());
  for (auto& [point, members] : points) groups.push_back(std::move(members));
  parallel_for_cost(groups.size(), kFlopsPerHit * (hits.size() / std::max<std::size_t>(groups.size(), 1)),
                    [&](std::size_t g) { grade_point(hits, spectra, std::move(groups[g]), rows); });
}

void vote_first_motion(std::vector<AnalysedHit>& hits) {
  std::map<std::pair<int, std::size_t>, std::vector<std::size_t>> voters;  // by point and channel
  std::map<std::pair<int, std::size_t>, std::size_t> unclear;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    for (std::size_t c = 0; hits[h].accepted && c < hits[h].responses.size(); ++c) {
      if (hits[h].responses[c].polarity != 0) {
        voters[{hits[h].point, c}].push_back(h);
      } else if (!hits[h].responses[c].dead) {
        ++unclear[{hits[h].point, c}];
      }
    }
  }
  for (const auto& [point_and_channel, members] : voters) {
    const std::size_t channel = point_and_channel.second;
    const auto with_push = [&](std::size_t h) { return hits[h].responses[channel].polarity * hits[h].hit.peak_N > 0; };
    const auto with = static_cast<std::size_t>(std::count_if(members.begin(), members.end(), with_push));
    const std::size_t against = members.size() - with;
    const bool undecided =
        static_cast<double>(std::min(with, against)) > kMaxDissent * static_cast<double>(members.size()) ||
        unclear[point_and_channel] > members.size();
    for (const std::size_t h : members) {
      if (!undecided && with_push(h) == (with > against)) continue;
      hits[h].responses[channel].polarity = 0;
      hits[h].responses[channel].delay_s.reset();
    }
  }
}

}  // namespace percuss::pipeline
