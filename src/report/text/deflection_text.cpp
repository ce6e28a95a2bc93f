#include "report/text/deflection_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "pipeline/warnings/sensor_name.hpp"
#include "report/text/number_format.hpp"
#include "report/text/text_table.hpp"
#include "report/text/warnings_text.hpp"

namespace percuss::report {
namespace {

std::string millimetres(double value_m, double std_m) {
  return std::isnan(value_m) ? "not known" : value_with_std(1000 * value_m, 1000 * std_m) + " mm";
}

}  // namespace

double sample_time_s(const pipeline::Analysis& analysis, const pipeline::DeflectedHit& hit, std::size_t sample) {
  return hit.first_s + static_cast<double>(sample) / analysis.record().fs_Hz;
}

ReportText deflection_tables(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test) {
  using Align = TextTable::Align;
  TextTable hits({{"hit", Align::right},
                  {"point", Align::right},
                  {"sensor"},
                  {"largest deflection", Align::right},
                  {"at", Align::right},
                  {"drift at the end", Align::right},
                  {"method"}});
  for (const pipeline::DeflectedHit& hit : test.hits) {
    const metrics::Deflection& d = hit.deflection;
    hits.add({fmt::format("{}", hit.hit + 1), analysis.point_names().name(hit.point),
              pipeline::sensor_name(analysis.record().accel, hit.channel), millimetres(d.peak_m, d.peak_std_m),
              d.has_peak() ? fmt::format("{:.4f} s", sample_time_s(analysis, hit, d.peak)) : "",
              fmt::format("{:.2g} mm", 1000 * d.drift_m), name_of(d.method)});
  }
  TextTable points(
      {{"point", Align::right}, {"sensor"}, {"hits", Align::right}, {"mean of the largest deflections", Align::right}});
  bool repeats = false;
  for (const pipeline::PointDeflection& point : test.points) {
    points.add(
        {analysis.point_names().name(point.point), pipeline::sensor_name(analysis.record().accel, point.channel),
         fmt::format("{}", point.hits),
         point.directions_differ ? "none: the hits differ in direction" : millimetres(point.peak_m, point.std_m)});
    repeats = repeats || point.hits > 1;
  }
  ReportText text;
  text += hits;
  if (repeats) {
    text += "\n";
    text += points;
  }
  for (const pipeline::ImpactSpeed& speed : test.speeds) {
    text += fmt::format("hit {}: speed of the ball {} m/s\n", speed.hit + 1,
                        value_with_std(speed.speed_mps, speed.std_mps));
  }
  if (!test.warnings.empty()) text += "\n";
  text += warnings_text(test.warnings);
  return text;
}

ReportText deflection_text(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test) {
  return one_line(input_name(analysis.record().source()), 400) + "\n\n" + deflection_tables(analysis, test);
}

}  // namespace percuss::report
