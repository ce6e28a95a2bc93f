#include "report/deflection_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

#include "acquire/formats/hdf5/hdf5_output.hpp"

namespace percuss::report {

std::string deflection_csv(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test) {
  std::string text = "hit,channel,t_s,velocity_mps,deflection_m,deflection_std_m,point,position_m\n";
  for (const pipeline::DeflectedHit& hit : test.hits) {
    const metrics::Deflection& d = hit.deflection;
    for (std::size_t i = 0; i < d.deflection_m.size(); ++i) {
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},", hit.hit, hit.channel, sample_time_s(analysis, hit, i),
                     d.velocity_mps[i], d.deflection_m[i]);
      if (!d.std_m.empty()) fmt::format_to(std::back_inserter(text), "{}", d.std_m[i]);
      fmt::format_to(std::back_inserter(text), ",{},", hit.point);
      if (hit.position_m) fmt::format_to(std::back_inserter(text), "{}", *hit.position_m);
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

}  // namespace percuss::report
