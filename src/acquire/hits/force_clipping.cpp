#include "acquire/hits/force_clipping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace percuss::acquire {
namespace {

constexpr double kRounding = 1e-12;  // of the peak: the baseline was subtracted and is added again
// Different hits with equal peaks. By chance, the probability at 16 bits is 1e-7 for three hits and 1e-3 for two.
constexpr std::size_t kMinCoincidingPeaks = 3;

// With the baseline, as recorded.
double raw_peak_N(const Hit& hit) { return hit.peak_N + hit.baseline_N; }

bool same(double a, double b) { return std::abs(a - b) <= kRounding * std::max(std::abs(a), std::abs(b)); }

struct ForceSide {
  std::size_t file = 0;
  double sign = 1;
  bool includes(const Hit& hit, const Record& record) const {
    return sign * hit.peak_N > 0 && record.rows[hit.row].file == file;
  }
};

std::size_t samples_at_peak(const Hit& hit) {
  return static_cast<std::size_t>(
      std::count_if(hit.gated_N.begin(), hit.gated_N.end(), [&](double force_N) { return same(force_N, hit.peak_N); }));
}

// Whether two rows hold one hit recorded twice.
bool is_same_hit(const Hit& a, const Hit& b) {
  return std::equal(a.gated_N.begin(), a.gated_N.end(), b.gated_N.begin(), b.gated_N.end(),
                    [&](double x, double y) { return std::abs(x - y) <= kRounding * std::abs(a.peak_N); });
}

// Whether the equal peaks of these hits exclude chance: at least kMinCoincidingPeaks hits are different, or two
// different hits have two samples or more at the peak.
bool peaks_coincide(const std::vector<const Hit*>& hits) {
  std::vector<const Hit*> different;
  for (const Hit* hit : hits) {
    if (std::none_of(different.begin(), different.end(), [&](const Hit* other) { return is_same_hit(*hit, *other); }))
      different.push_back(hit);
  }
  const auto flat =
      std::count_if(different.begin(), different.end(), [](const Hit* hit) { return samples_at_peak(*hit) > 1; });
  return different.size() >= kMinCoincidingPeaks || flat > 1;
}

// The clipping level from the overloaded hits of one file and sign, or from peaks that coincide.
std::optional<double> clipping_level_N(const std::vector<Hit>& hits, const Record& record, const ForceSide& side) {
  std::optional<double> furthest, level;
  for (const Hit& hit : hits) {
    if (!side.includes(hit, record)) continue;
    const double peak = raw_peak_N(hit);
    if (!furthest || side.sign * (peak - *furthest) > 0) furthest = peak;
    if (has_finding(hit.findings, FindingCode::overload) && (!level || side.sign * (peak - *level) > 0)) level = peak;
  }
  if (level && same(*level, *furthest)) return level;
  std::vector<const Hit*> highest;
  for (const Hit& hit : hits) {
    if (side.includes(hit, record) && same(raw_peak_N(hit), *furthest)) highest.push_back(&hit);
  }
  return peaks_coincide(highest) ? furthest : std::nullopt;
}

void add_overload(Hit& hit) {
  hit.findings.push_back(
      {.code = FindingCode::overload,
       .severity = Severity::reject,
       .value = static_cast<double>(samples_at_peak(hit)),
       .message = fmt::format("force clipped at {:.4g} N, the clipping level of other hits; raise the input range",
                              hit.peak_N)});
}

}  // namespace

void grade_force_clipping(std::vector<Hit>& hits, const Record& record) {
  for (std::size_t file = 0; file < std::max<std::size_t>(record.files.size(), 1); ++file) {
    for (const double sign : {1.0, -1.0}) {
      const ForceSide side{.file = file, .sign = sign};
      const auto level = clipping_level_N(hits, record, side);
      if (!level) continue;
      for (Hit& hit : hits) {
        if (side.includes(hit, record) && !has_finding(hit.findings, FindingCode::overload) &&
            same(raw_peak_N(hit), *level))
          add_overload(hit);
      }
    }
  }
}

}  // namespace percuss::acquire
