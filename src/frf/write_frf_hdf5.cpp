#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "acquire/hdf5_output.hpp"
#include "core/units.hpp"
#include "frf/write_frf.hpp"

namespace percuss {
namespace {

// Where the sensors sit, as far as it is known.
void write_sensors(hdf5::OutputHdf5& out, const FrfRecord& record) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> angle_deg, position_m;
  for (const SignalInfo& signal : record.accel) {
    angle_deg.push_back(signal.angle_rad ? *signal.angle_rad * kRadian_deg : kUnknown);
    position_m.push_back(signal.position_m.value_or(kUnknown));
  }
  const auto known = [](double x) { return std::isfinite(x); };
  if (std::any_of(angle_deg.begin(), angle_deg.end(), known)) out.set_numbers("frf", "angle_deg", angle_deg, true);
  if (std::any_of(position_m.begin(), position_m.end(), known)) out.set_numbers("frf", "position_m", position_m, true);
}

}  // namespace

void write_frf_record_hdf5(const std::string& path, const FrfRecord& record, FrfKind kind, bool force) {
  const std::size_t count = record.lines.count;
  std::map<int, std::size_t> points;
  for (const PointFrf& frf : record.frfs) points.emplace(frf.point, points.size());
  const std::array shape{points.size(), record.accel.size(), count};
  const auto all = [&](auto&& has) { return std::all_of(record.frfs.begin(), record.frfs.end(), has); };
  const bool has_std = all([](const PointFrf& f) { return !f.frf.std.empty(); });
  const bool has_coherence = all([](const PointFrf& f) { return !f.frf.coherence.empty(); });

  hdf5::OutputHdf5 out(path, force);
  out.create_set("frequency_hz", std::array{count});
  std::vector<double> freq_Hz(count);
  for (std::size_t k = 0; k < count; ++k) freq_Hz[k] = record.lines.freq_Hz(k);
  out.write("frequency_hz", {}, 0, std::span<const double>(freq_Hz));
  out.create_set("frf", shape, hdf5::Stored::complex128);
  if (has_std) out.create_set("frf_std", shape);
  if (has_coherence) out.create_set("coherence", shape);
  std::vector<double> numbers, averages;
  for (const auto& [point, index] : points) numbers.push_back(point);
  out.create_set("point", std::array{numbers.size()}, hdf5::Stored::int32);
  out.write("point", {}, 0, std::span<const double>(numbers));
  for (const PointFrf& frf : record.frfs) {
    const Frf shown = converted(frf.frf, record.lines, kind, record.decay_per_s);
    const std::array at{points.at(frf.point), frf.channel};
    out.write("frf", at, 0, std::span<const Complex>(shown.value));
    averages.push_back(static_cast<double>(frf.frf.averages));
    if (has_std) out.write("frf_std", at, 0, std::span<const double>(shown.std));
    if (has_coherence) out.write("coherence", at, 0, std::span<const double>(shown.coherence));
  }
  out.set_text("", "kind", name_of(kind));
  write_sensors(out, record);
  if (record.decay_per_s > 0) out.set_numbers("", "decay_per_s", std::array{record.decay_per_s}, false);
  out.set_text("", "unit", unit_of(kind));
  out.set_text("", "estimator", record.estimator);
  out.set_numbers("", "averages", std::array{*std::min_element(averages.begin(), averages.end())}, false);
  out.commit();
}

}  // namespace percuss
