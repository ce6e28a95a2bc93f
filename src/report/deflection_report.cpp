#include "report/deflection_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "acquire/formats/hdf5/hdf5_output.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "report/json/json_document.hpp"
#include "report/text/number_format.hpp"
#include "report/text/text_table.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxHitsDrawn = 12;

double time_s(const pipeline::Analysis& analysis, const pipeline::DeflectedHit& hit, std::size_t sample) {
  return hit.first_s + static_cast<double>(sample) / analysis.record().fs_Hz;
}

Json hit_json(const pipeline::Analysis& analysis, const pipeline::DeflectedHit& hit) {
  const metrics::Deflection& d = hit.deflection;
  const bool told = d.has_peak();
  return {{"index", hit.hit},
          {"channel", hit.channel},
          {"point", hit.point},
          {"position_m", hit.position_m ? Json(*hit.position_m) : Json()},
          {"peak_m", std::abs(d.peak_m)},
          {"peak_time_s", told ? Json(time_s(analysis, hit, d.peak)) : Json()},
          {"peak_std_m", d.std_m.empty() ? Json() : Json(d.peak_std_m)},
          {"direction", told ? Json(d.peak_m < 0 ? -1 : 1) : Json()},
          {"forward_m", std::abs(d.forward_m)},
          {"forward_std_m", d.std_m.empty() ? Json() : Json(d.forward_std_m)},
          {"method", name_of(d.method)},
          {"bias_mps2", d.bias_mps2},
          {"drift_m", d.drift_m},
          {"held", d.held}};
}

std::string millimetres(double value_m, double std_m) {
  return std::isnan(value_m) ? "not told" : value_with_std(1000 * value_m, 1000 * std_m) + " mm";
}

double measured_peak_m(const pipeline::DeflectedHit& hit) {
  return hit.deflection.has_peak() ? std::abs(hit.deflection.peak_m) : 0;
}

std::string channel_name(const pipeline::Analysis& analysis, std::size_t channel) {
  const std::string& name = analysis.record().accel[channel].name;
  return name.empty() ? fmt::format("accel {}", channel + 1) : one_line(name, 40);
}

}  // namespace

std::string deflection_json(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test) {
  Json json{{"schema", "percuss/deflection/1"}, {"version", version()}, {"inputs", Json::array()}};
  for (const acquire::InputFile& file : analysis.record().files)
    json["inputs"].push_back({{"path", file.path}, {"bytes", file.bytes}});
  json["fs_hz"] = analysis.record().fs_Hz;
  json["hits"] = Json::array();
  for (const pipeline::DeflectedHit& hit : test.hits) json["hits"].push_back(hit_json(analysis, hit));
  json["points"] = Json::array();
  for (const pipeline::PointDeflection& point : test.points) {
    json["points"].push_back({{"point", point.point},
                              {"channel", point.channel},
                              {"position_m", point.position_m ? Json(*point.position_m) : Json()},
                              {"hits", point.hits},
                              {"peak_m", point.peak_m},
                              {"peak_std_m", point.std_m},
                              {"forward_m", point.forward_m},
                              {"forward_std_m", point.forward_std_m}});
  }
  json["impact_speeds"] = Json::array();
  for (const pipeline::ImpactSpeed& speed : test.speeds) {
    json["impact_speeds"].push_back(
        {{"index", speed.hit}, {"speed_mps", speed.speed_mps}, {"speed_std_mps", speed.std_mps}});
  }
  json["warnings"] = Json::array();
  for (const pipeline::Warning& warning : test.warnings)
    json["warnings"].push_back({{"code", warning.code}, {"message", warning.message}});
  return indented_text(json) + "\n";
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
    hits.add({fmt::format("{}", hit.hit), fmt::format("{}", hit.point), channel_name(analysis, hit.channel),
              millimetres(d.peak_m, d.peak_std_m),
              d.has_peak() ? fmt::format("{:.4f} s", time_s(analysis, hit, d.peak)) : "",
              fmt::format("{:.2g} mm", 1000 * d.drift_m), name_of(d.method)});
  }
  TextTable points(
      {{"point", Align::right}, {"sensor"}, {"hits", Align::right}, {"mean of the largest deflections", Align::right}});
  bool repeats = false;
  for (const pipeline::PointDeflection& point : test.points) {
    points.add({fmt::format("{}", point.point), channel_name(analysis, point.channel), fmt::format("{}", point.hits),
                millimetres(point.peak_m, point.std_m)});
    repeats = repeats || point.hits > 1;
  }
  ReportText text;
  text += hits;
  if (repeats) {
    text += "\n";
    text += points;
  }
  for (const pipeline::ImpactSpeed& speed : test.speeds) {
    text +=
        fmt::format("hit {}: the ball came with {} m/s\n", speed.hit, value_with_std(speed.speed_mps, speed.std_mps));
  }
  if (!test.warnings.empty()) text += "\n";
  for (const pipeline::Warning& warning : test.warnings) text.warn(warning.message);
  return text;
}

ReportText deflection_text(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test) {
  return one_line(input_name(analysis.record().source()), 400) + "\n\n" + deflection_tables(analysis, test);
}

std::string deflection_csv(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test) {
  std::string text = "hit,channel,t_s,velocity_mps,deflection_m,deflection_std_m\n";
  for (const pipeline::DeflectedHit& hit : test.hits) {
    const metrics::Deflection& d = hit.deflection;
    for (std::size_t i = 0; i < d.deflection_m.size(); ++i) {
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},", hit.hit, hit.channel, time_s(analysis, hit, i),
                     d.velocity_mps[i], d.deflection_m[i]);
      if (!d.std_m.empty()) fmt::format_to(std::back_inserter(text), "{}", d.std_m[i]);
      text += '\n';
    }
  }
  return text;
}

void write_deflection_hdf5(const std::string& path, const pipeline::Analysis& analysis,
                           const pipeline::ImpactTest& test, bool force) {
  const std::size_t channels = analysis.record().accel.size(), hits = test.hits.size() / channels;
  std::size_t samples = 0;
  for (const pipeline::DeflectedHit& hit : test.hits) samples = std::max(samples, hit.deflection.deflection_m.size());
  acquire::hdf5::OutputHdf5 out(path, force);
  const std::array shape{hits, channels, samples};
  const std::array<std::pair<const char*, std::vector<double> metrics::Deflection::*>, 3> sets{
      {{"deflection_m", &metrics::Deflection::deflection_m},
       {"velocity_mps", &metrics::Deflection::velocity_mps},
       {"deflection_std_m", &metrics::Deflection::std_m}}};
  for (const auto& [name, member] : sets) {
    out.create_set(name, shape);
    for (std::size_t i = 0; i < test.hits.size(); ++i) {
      std::vector<double> values = test.hits[i].deflection.*member;
      values.resize(samples, std::numeric_limits<double>::quiet_NaN());
      out.write(name, std::array{i / channels, i % channels}, 0, std::span<const double>(values));
    }
  }
  std::vector<double> numbers, points, starts;
  for (std::size_t h = 0; h < hits; ++h) {
    const pipeline::DeflectedHit& hit = test.hits[h * channels];
    numbers.push_back(static_cast<double>(hit.hit));
    points.push_back(hit.point);
    starts.push_back(hit.first_s);
  }
  out.create_set("hit", std::array{hits}, acquire::hdf5::Stored::int32);
  out.write("hit", {}, 0, std::span<const double>(numbers));
  out.create_set("point", std::array{hits}, acquire::hdf5::Stored::int32);
  out.write("point", {}, 0, std::span<const double>(points));
  out.create_set("start_s", std::array{hits});
  out.write("start_s", {}, 0, std::span<const double>(starts));
  out.set_numbers("", "fs", std::array{analysis.record().fs_Hz}, false);
  out.commit();
}

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
      curve.x.push_back(time_s(analysis, *hit, i));
      curve.y.push_back(1000 * hit->deflection.deflection_m[i]);
    }
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

}  // namespace percuss::report
