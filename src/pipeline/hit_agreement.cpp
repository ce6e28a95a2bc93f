#include "pipeline/hit_agreement.hpp"

#include <fmt/format.h>

#include <map>

#include "core/statistics.hpp"
#include "frf/agreement.hpp"

namespace percuss {
namespace {

constexpr std::size_t kLeastHits = 4;    // fewer cannot outvote one
constexpr double kOutlierRatio = 25;     // times the others' disagreement (five times in amplitude)
constexpr double kOutlierEnergy = 0.05;  // of its own energy: smaller misfits do no harm, however unlike the others
constexpr double kLowCoherence = 0.9;

std::vector<double> without(const std::vector<double>& values, std::size_t i) {
  std::vector<double> rest = values;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
  return rest;
}

std::string disagreement(double explained) {
  const std::string how_far = explained > 0 ? fmt::format("explain only {:.0f} % of its response", explained * 100)
                                            : "do not explain its response at all";
  return "the other hits " + how_far + ": did the point or the direction change (--files points)?";
}

}  // namespace

void grade_agreement(std::vector<AnalysedHit>& hits, const std::vector<HitSpectra>& spectra) {
  std::map<int, std::vector<std::size_t>> points;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    if (hits[h].accepted && spectra[h].force != nullptr) points[hits[h].point].push_back(h);
  }
  for (const auto& [point, members] : points) {
    if (members.size() < 2) continue;
    std::vector<const std::vector<Complex>*> force;
    std::vector<std::vector<const std::vector<Complex>*>> accel;
    for (const std::size_t h : members) {
      force.push_back(spectra[h].force);
      accel.push_back(spectra[h].accel);
    }
    const auto left = unexplained_by_others(force, accel);
    for (std::size_t i = 0; i < members.size(); ++i) {
      AnalysedHit& hit = hits[members[i]];
      const double typical = median(without(left, i));
      if (members.size() >= kLeastHits && left[i] > kOutlierRatio * typical && left[i] > kOutlierEnergy) {
        hit.hit.findings.push_back(
            {.code = FindingCode::outlier,
             .severity = Severity::reject,
             .value = left[i],
             .message = fmt::format("unlike the others: their FRFs leave {:.0f} % of its response unexplained, of "
                                    "each other's {:.1f} %",
                                    left[i] * 100, typical * 100)});
        if (!hit.by_user) hit.accepted = false;
      } else if (1 - left[i] < kLowCoherence) {
        hit.hit.findings.push_back({.code = FindingCode::low_coherence,
                                    .severity = Severity::warn,
                                    .value = 1 - left[i],
                                    .message = disagreement(1 - left[i])});
      }
    }
  }
}

}  // namespace percuss
