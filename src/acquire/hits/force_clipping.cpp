#include "acquire/hits/force_clipping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace percuss::acquire {
namespace {

constexpr double kRounding = 1e-12;  // of the peak: the baseline was taken off and is added again
constexpr std::size_t kMinCoincidingPeaks =
    3;  // unlike hits that peak at one number: 1e-7 by chance at 16 bits, and two 1e-3

bool overloaded(const Hit& hit) {
  return std::any_of(hit.findings.begin(), hit.findings.end(),
                     [](const Finding& f) { return f.code == FindingCode::overload; });
}

// As the recorder saw it.
double raw_peak_N(const Hit& hit) { return hit.peak_N + hit.baseline_N; }

bool same(double a, double b) { return std::abs(a - b) <= kRounding * std::max(std::abs(a), std::abs(b)); }

struct ForceSide {
  std::size_t file = 0;
  double sign = 1;
  bool holds(const Hit& hit, const Record& record) const {
    return sign * hit.peak_N > 0 && record.rows[hit.row].file == file;
  }
};

std::size_t samples_at_peak(const Hit& hit) {
  return static_cast<std::size_t>(
      std::count_if(hit.gated_N.begin(), hit.gated_N.end(), [&](double force_N) { return same(force_N, hit.peak_N); }));
}

// One blow recorded twice, which agrees with itself in everything.
bool is_same_hit(const Hit& a, const Hit& b) {
  return std::equal(a.gated_N.begin(), a.gated_N.end(), b.gated_N.begin(), b.gated_N.end(),
                    [&](double x, double y) { return std::abs(x - y) <= kRounding * std::abs(a.peak_N); });
}

// Unlike blows whose peaks are one number, or two of them with two samples at it: no chance, although none by itself
// shows more than any peak would.
bool peaks_coincide(const std::vector<const Hit*>& hits) {
  std::vector<const Hit*> unlike;
  for (const Hit* hit : hits) {
    if (std::none_of(unlike.begin(), unlike.end(), [&](const Hit* other) { return is_same_hit(*hit, *other); }))
      unlike.push_back(hit);
  }
  const auto flat =
      std::count_if(unlike.begin(), unlike.end(), [](const Hit* hit) { return samples_at_peak(*hit) > 1; });
  return unlike.size() >= kMinCoincidingPeaks || flat > 1;
}

// The rail that the overloaded hits of one file and sign show, or the peaks of several together.
std::optional<double> clipping_level_N(const std::vector<Hit>& hits, const Record& record, const ForceSide& side) {
  std::optional<double> furthest, rail;
  for (const Hit& hit : hits) {
    if (!side.holds(hit, record)) continue;
    const double peak = raw_peak_N(hit);
    if (!furthest || side.sign * (peak - *furthest) > 0) furthest = peak;
    if (overloaded(hit) && (!rail || side.sign * (peak - *rail) > 0)) rail = peak;
  }
  if (rail && same(*rail, *furthest)) return rail;
  std::vector<const Hit*> highest;
  for (const Hit& hit : hits) {
    if (side.holds(hit, record) && same(raw_peak_N(hit), *furthest)) highest.push_back(&hit);
  }
  return peaks_coincide(highest) ? furthest : std::nullopt;
}

void add_overload(Hit& hit) {
  hit.findings.push_back({.code = FindingCode::overload,
                          .severity = Severity::reject,
                          .value = static_cast<double>(samples_at_peak(hit)),
                          .message = fmt::format("force clipped: it peaks at the rail that other hits show, {:.3g} N; "
                                                 "raise the input range",
                                                 hit.peak_N)});
}

}  // namespace

void grade_force_clipping(std::vector<Hit>& hits, const Record& record) {
  for (std::size_t file = 0; file < std::max<std::size_t>(record.files.size(), 1); ++file) {
    for (const double sign : {1.0, -1.0}) {
      const ForceSide side{.file = file, .sign = sign};
      const auto rail = clipping_level_N(hits, record, side);
      if (!rail) continue;
      for (Hit& hit : hits) {
        if (side.holds(hit, record) && !overloaded(hit) && same(raw_peak_N(hit), *rail)) add_overload(hit);
      }
    }
  }
}

}  // namespace percuss::acquire
