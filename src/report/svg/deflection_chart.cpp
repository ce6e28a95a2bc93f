#include "report/svg/deflection_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/text/deflection_text.hpp"

namespace percuss::report {
namespace {

constexpr std::size_t kMaxHitsDrawn = 12;

double measured_peak_m(const pipeline::DeflectedHit& hit) {
  return hit.deflection.has_peak() ? std::abs(hit.deflection.peak_m) : 0;
}

}  // namespace

LineChart deflection_chart(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test) {
  std::vector<const pipeline::DeflectedHit*> largest;
  largest.reserve(test.hits.size());
  for (const pipeline::DeflectedHit& hit : test.hits) largest.push_back(&hit);
  std::stable_sort(largest.begin(), largest.end(),
                   [](const pipeline::DeflectedHit* a, const pipeline::DeflectedHit* b) {
                     return measured_peak_m(*a) > measured_peak_m(*b);
                   });
  largest.resize(std::min(largest.size(), kMaxHitsDrawn));
  LineChart chart{
      .title = "Deflection at the accelerometer", .x = {.label = "time, s"}, .y = {.label = "deflection, mm"}};
  for (const pipeline::DeflectedHit* hit : largest) {
    ChartCurve curve{.name = fmt::format("hit {}, {}", hit->hit, channel_name(analysis, hit->channel))};
    for (std::size_t i = 0; i < hit->deflection.deflection_m.size(); ++i) {
      curve.x.push_back(sample_time_s(analysis, *hit, i));
      curve.y.push_back(1000 * hit->deflection.deflection_m[i]);
    }
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

}  // namespace percuss::report
