#include <algorithm>
#include <array>
#include <map>

#include "acquire/formats/hdf5/hdf5_output.hpp"
#include "acquire/formats/hdf5/write_frf_hdf5.hpp"
#include "acquire/record/sensor_numbers.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

std::string within(const std::string& group, const char* name) { return group.empty() ? name : group + "/" + name; }

// Writes the angles and positions of the sensors, NaN where unknown; nothing when all are unknown.
void write_frf_sensors(hdf5::OutputHdf5& out, const std::string& set, const FrfRecord& record) {
  const auto angle_deg = sensor_numbers(record.accel, &SignalInfo::angle_rad, kRadian_deg);
  const auto position_m = sensor_numbers(record.accel, &SignalInfo::position_m);
  if (!angle_deg.empty()) out.set_numbers(set, "angle_deg", angle_deg, true);
  if (!position_m.empty()) out.set_numbers(set, "position_m", position_m, true);
}

void write_attributes(hdf5::OutputHdf5& out, const std::string& group, const FrfRecord& record, FrfKind kind) {
  out.set_text(group, "kind", name_of(kind));
  write_frf_sensors(out, within(group, "frf"), record);
  if (record.decay_per_s > 0) out.set_numbers(group, "decay_per_s", std::array{record.decay_per_s}, false);
  out.set_text(group, "unit", unit_of(kind));
  if (!record.estimator.empty()) out.set_text(group, "estimator", record.estimator);
  const auto fewest =
      std::min_element(record.frfs.begin(), record.frfs.end(),
                       [](const PointFrf& a, const PointFrf& b) { return a.frf.averages < b.frf.averages; });
  out.set_numbers(group, "averages", std::array{static_cast<double>(fewest->frf.averages)}, false);
}

}  // namespace

void write_frf_group(hdf5::OutputHdf5& out, const std::string& group, const FrfRecord& record, FrfKind kind) {
  const std::size_t count = record.lines.count;
  std::map<int, std::size_t> points;
  for (const PointFrf& frf : record.frfs) points.emplace(frf.point, points.size());
  const std::array shape{points.size(), record.accel.size(), count};
  const auto all_have = [&](auto&& has) { return std::all_of(record.frfs.begin(), record.frfs.end(), has); };
  const bool has_std = all_have([](const PointFrf& f) { return !f.frf.std.empty(); });
  const bool has_coherence = all_have([](const PointFrf& f) { return !f.frf.coherence.empty(); });

  const std::string frequency = within(group, "frequency_hz"), frfs = within(group, "frf"),
                    stds = within(group, "frf_std"), coherence = within(group, "coherence"),
                    point_set = within(group, "point");
  if (!group.empty()) out.create_group(group);
  out.create_set(frequency, std::array{count});
  const std::vector<double> freq_Hz = frequencies_Hz(record.lines);
  out.write(frequency, {}, 0, std::span<const double>(freq_Hz));
  out.create_set(frfs, shape, hdf5::Stored::complex128);
  if (has_std) out.create_set(stds, shape);
  if (has_coherence) out.create_set(coherence, shape);
  std::vector<double> numbers;
  numbers.reserve(points.size());
  for (const auto& [point, index] : points) numbers.push_back(point);
  out.create_set(point_set, std::array{numbers.size()}, hdf5::Stored::int32);
  out.write(point_set, {}, 0, std::span<const double>(numbers));
  for (const PointFrf& frf : record.frfs) {
    const Frf stored = converted(frf.frf, record.lines, kind, record.decay_per_s);
    const std::array at{points.at(frf.point), frf.channel};
    out.write(frfs, at, 0, std::span<const Complex>(stored.value));
    if (has_std) out.write(stds, at, 0, std::span<const double>(stored.std));
    if (has_coherence) out.write(coherence, at, 0, std::span<const double>(stored.coherence));
  }
  write_attributes(out, group, record, kind);
}

void write_frf_record_hdf5(const std::string& path, const FrfRecord& record, FrfKind kind, bool force) {
  hdf5::OutputHdf5 out(path, force);
  write_frf_group(out, "", record, kind);
  out.commit();
}

}  // namespace percuss::acquire
