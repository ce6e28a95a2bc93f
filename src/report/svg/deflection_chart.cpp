#include "report/svg/deflection_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/warnings/sensor_name.hpp"
#include "report/text/deflection_text.hpp"

namespace percuss::report {
namespace {

constexpr std::size_t kMaxHitsDrawn = 12, kMaxPointsDrawn = 24;
constexpr double kMaxDrawnStd = 0.5;  // of the peak: a curve ends where its ± exceeds this part

double measured_peak_m(const pipeline::DeflectedHit& hit) {
  return hit.deflection.has_peak() ? std::abs(hit.deflection.peak_m) : 0;
}

std::vector<const pipeline::DeflectedHit*> largest_hits(const pipeline::ImpactTest& test) {
  std::vector<const pipeline::DeflectedHit*> out;
  out.reserve(test.hits.size());
  for (const pipeline::DeflectedHit& hit : test.hits) out.push_back(&hit);
  std::stable_sort(out.begin(), out.end(),
                   [](const auto* a, const auto* b) { return measured_peak_m(*a) > measured_peak_m(*b); });
  out.resize(std::min(out.size(), kMaxHitsDrawn));
  return out;
}

// The hit of each point whose peak is nearest to the mean of its hits, in the order of the points.
std::vector<const pipeline::DeflectedHit*> hits_of_points(const pipeline::ImpactTest& test) {
  std::vector<const pipeline::DeflectedHit*> out;
  for (const pipeline::PointDeflection& point : test.points) {
    if (out.size() == kMaxPointsDrawn) break;
    const pipeline::DeflectedHit* nearest = nullptr;
    const auto distance = [&](const pipeline::DeflectedHit& hit) {
      return std::isnan(point.peak_m) ? 0 : std::abs(measured_peak_m(hit) - std::abs(point.peak_m));
    };
    for (const pipeline::DeflectedHit& hit : test.hits) {
      if (hit.point != point.point || hit.channel != point.channel) continue;
      if (nearest == nullptr || distance(hit) < distance(*nearest)) nearest = &hit;
    }
    if (nearest != nullptr) out.push_back(nearest);
  }
  return out;
}

std::string place_of(const pipeline::Analysis& analysis, const pipeline::DeflectedHit& hit) {
  if (hit.position_m) return fmt::format("{:g} m", *hit.position_m);
  return fmt::format("point {}", analysis.point_names().name(hit.point));
}

// The samples before the standard deviation exceeds kMaxDrawnStd of the peak. A hit without a significant deflection
// has no peak; it is drawn as far as the peak of another hit, `largest_m`, allows.
std::size_t determined_samples(const metrics::Deflection& d, double largest_m) {
  const double peak_m = d.has_peak() ? std::abs(d.peak_m) : largest_m;
  if (d.std_m.empty() || !(peak_m > 0)) return d.deflection_m.size();
  const auto from = d.std_m.begin() + static_cast<std::ptrdiff_t>(d.has_peak() ? d.peak : 0);
  const auto end = std::find_if(from, d.std_m.end(), [&](double std_m) { return std_m > kMaxDrawnStd * peak_m; });
  return static_cast<std::size_t>(end - d.std_m.begin());
}

// Adds the curve of a hit, with the band of its standard deviation.
void add_curve(const pipeline::Analysis& analysis, const pipeline::DeflectedHit& hit, std::string name,
               std::size_t samples, LineChart& chart) {
  const metrics::Deflection& d = hit.deflection;
  ChartCurve curve{.name = std::move(name)};
  ChartBand band{.style = chart.curves.size()};
  for (std::size_t i = 0; i < samples; ++i) {
    curve.x.push_back(sample_time_s(analysis, hit, i));
    curve.y.push_back(1000 * d.deflection_m[i]);
    if (d.std_m.empty()) continue;
    band.low.push_back(1000 * (d.deflection_m[i] - d.std_m[i]));
    band.high.push_back(1000 * (d.deflection_m[i] + d.std_m[i]));
  }
  band.x = curve.x;
  if (!band.low.empty()) chart.bands.push_back(std::move(band));
  chart.curves.push_back(std::move(curve));
}

}  // namespace

LineChart deflection_chart(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test) {
  const bool several = std::any_of(test.points.begin(), test.points.end(), [&](const pipeline::PointDeflection& p) {
    return p.point != test.points.front().point;
  });
  const bool one_channel = analysis.record().accel.size() == 1;
  LineChart chart{.title = several ? "Deflection at the struck points" : "Deflection at the accelerometer",
                  .x = {.label = "time, s"},
                  .y = {.label = "deflection, mm"},
                  .curves = {}};
  const std::vector<const pipeline::DeflectedHit*> hits = several ? hits_of_points(test) : largest_hits(test);
  double largest_m = 0;
  for (const pipeline::DeflectedHit* hit : hits) largest_m = std::max(largest_m, measured_peak_m(*hit));
  bool all_drawn = true;
  for (const pipeline::DeflectedHit* hit : hits) {
    const std::string sensor = pipeline::sensor_name(analysis.record().accel, hit->channel);
    const std::size_t samples = determined_samples(hit->deflection, largest_m);
    all_drawn = all_drawn && samples == hit->deflection.deflection_m.size();
    add_curve(analysis, *hit,
              !several      ? fmt::format("hit {}, {}", hit->hit + 1, sensor)
              : one_channel ? place_of(analysis, *hit)
                            : fmt::format("{}, {}", place_of(analysis, *hit), sensor),
              samples, chart);
  }
  if (!all_drawn) chart.title += ", until its ± exceeds half the peak";
  return chart;
}

std::optional<LineChart> deflection_over_position(const pipeline::Analysis& analysis,
                                                  const pipeline::ImpactTest& test) {
  LineChart chart{.title = "Largest deflection of the struck points",
                  .x = {.label = "position, m"},
                  .y = {.label = "largest deflection, mm"},
                  .curves = {}};
  for (std::size_t channel = 0; channel < analysis.record().accel.size(); ++channel) {
    ChartCurve mean{.name = pipeline::sensor_name(analysis.record().accel, channel), .marks = true};
    ChartBand band{.style = chart.curves.size()};
    for (const pipeline::PointDeflection& point : test.points) {
      if (point.channel != channel || !point.position_m || std::isnan(point.peak_m)) continue;
      mean.x.push_back(*point.position_m);
      mean.y.push_back(1000 * point.peak_m);
      band.low.push_back(1000 * (point.peak_m - point.std_m));
      band.high.push_back(1000 * (point.peak_m + point.std_m));
    }
    band.x = mean.x;
    if (mean.x.size() < 2) continue;
    const bool known = std::all_of(band.low.begin(), band.low.end(), [](double y) { return std::isfinite(y); });
    if (known) chart.bands.push_back(std::move(band));
    chart.curves.push_back(std::move(mean));
  }
  if (chart.curves.empty()) return {};
  return chart;
}

}  // namespace percuss::report
