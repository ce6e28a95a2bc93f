#include "acquire/shared_rail.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace percuss {
namespace {

constexpr double kRounding = 1e-12;  // of the peak: the baseline was taken off and is added again

bool overloaded(const Hit& hit) {
  return std::any_of(hit.findings.begin(), hit.findings.end(),
                     [](const Finding& f) { return f.code == FindingCode::overload; });
}

// As the recorder saw it.
double raw_peak_N(const Hit& hit) { return hit.peak_N + hit.baseline_N; }

bool same(double a, double b) { return std::abs(a - b) <= kRounding * std::max(std::abs(a), std::abs(b)); }

struct Side {
  std::size_t file = 0;
  double sign = 1;
  bool holds(const Hit& hit, const Record& record) const {
    return sign * hit.peak_N > 0 && record.rows[hit.row].file == file;
  }
};

// The rail that the overloaded hits of one file and sign show.
std::optional<double> rail_N(const std::vector<Hit>& hits, const Record& record, const Side& side) {
  std::optional<double> furthest, rail;
  for (const Hit& hit : hits) {
    if (!side.holds(hit, record)) continue;
    const double peak = raw_peak_N(hit);
    if (!furthest || side.sign * (peak - *furthest) > 0) furthest = peak;
    if (overloaded(hit) && (!rail || side.sign * (peak - *rail) > 0)) rail = peak;
  }
  return rail && same(*rail, *furthest) ? rail : std::nullopt;
}

void add_overload(Hit& hit) {
  const auto at_rail =
      std::count_if(hit.gated_N.begin(), hit.gated_N.end(), [&](double force_N) { return same(force_N, hit.peak_N); });
  hit.findings.push_back(
      {.code = FindingCode::overload,
       .severity = Severity::reject,
       .value = static_cast<double>(at_rail),
       .message = fmt::format("force clipped: it peaks at the rail that another hit shows, {:.3g} N; "
                              "raise the input range",
                              hit.peak_N)});
}

}  // namespace

void grade_shared_rail(std::vector<Hit>& hits, const Record& record) {
  for (std::size_t file = 0; file < std::max<std::size_t>(record.files.size(), 1); ++file) {
    for (const double sign : {1.0, -1.0}) {
      const Side side{.file = file, .sign = sign};
      const auto rail = rail_N(hits, record, side);
      if (!rail) continue;
      for (Hit& hit : hits) {
        if (side.holds(hit, record) && !overloaded(hit) && same(raw_peak_N(hit), *rail)) add_overload(hit);
      }
    }
  }
}

}  // namespace percuss
