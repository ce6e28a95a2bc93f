#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "acquire/hdf5_output.hpp"
#include "core/units.hpp"
#include "report/frf_files.hpp"

namespace percuss {
namespace {

// The lines of the band within all lines: first and count.
std::pair<std::size_t, std::size_t> band_lines(const Analysis& analysis) {
  const LineRange& lines = analysis.lines();
  const auto [low, high] = analysis.band_Hz();
  const LineRange band = lines_in_band(lines.fs_Hz, lines.samples, low, high);
  return {band.first - lines.first, band.count};
}

// Where the sensors sit, as far as it is known.
void write_sensors(hdf5::OutputHdf5& out, const Analysis& analysis) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> angle_deg, position_m;
  for (const SignalInfo& signal : analysis.record().accel) {
    angle_deg.push_back(signal.angle_rad ? *signal.angle_rad * kRadian_deg : kUnknown);
    position_m.push_back(signal.position_m.value_or(kUnknown));
  }
  const auto known = [](double x) { return std::isfinite(x); };
  if (std::any_of(angle_deg.begin(), angle_deg.end(), known)) out.set_numbers("frf", "angle_deg", angle_deg, true);
  if (std::any_of(position_m.begin(), position_m.end(), known)) out.set_numbers("frf", "position_m", position_m, true);
}

}  // namespace

void write_frf_hdf5(const std::string& path, const Analysis& analysis, FrfKind kind, bool force) {
  const auto& frfs = analysis.frfs();
  const auto [first, count] = band_lines(analysis);
  std::map<int, std::size_t> points;
  for (const PointFrf& frf : frfs) points.emplace(frf.point, points.size());
  const std::array shape{points.size(), analysis.record().accel.size(), count};
  const bool averaged = std::all_of(frfs.begin(), frfs.end(), [](const PointFrf& frf) { return !frf.frf.std.empty(); });

  hdf5::OutputHdf5 out(path, force);
  out.create_set("frequency_hz", std::array{count});
  std::vector<double> freq_Hz(count);
  for (std::size_t k = 0; k < count; ++k) freq_Hz[k] = analysis.lines().freq_Hz(first + k);
  out.write("frequency_hz", {}, 0, std::span<const double>(freq_Hz));
  out.create_set("frf", shape, hdf5::Stored::complex128);
  if (averaged) {
    out.create_set("frf_std", shape);
    out.create_set("coherence", shape);
  }
  std::vector<double> numbers, averages;
  for (const auto& [point, index] : points) numbers.push_back(point);
  out.create_set("point", std::array{numbers.size()}, hdf5::Stored::int32);
  out.write("point", {}, 0, std::span<const double>(numbers));
  for (const PointFrf& frf : frfs) {
    const Frf shown = converted(frf.frf, analysis.lines(), kind, analysis.window_decay_per_s());
    const std::array at{points.at(frf.point), frf.channel};
    out.write("frf", at, 0, std::span<const Complex>(shown.value).subspan(first, count));
    averages.push_back(static_cast<double>(frf.frf.averages));
    if (!averaged) continue;
    out.write("frf_std", at, 0, std::span<const double>(shown.std).subspan(first, count));
    out.write("coherence", at, 0, std::span<const double>(shown.coherence).subspan(first, count));
  }
  out.set_text("", "kind", name_of(kind));
  write_sensors(out, analysis);
  if (analysis.window_decay_per_s() > 0)
    out.set_numbers("", "decay_per_s", std::array{analysis.window_decay_per_s()}, false);
  out.set_text("", "unit", unit_of(kind));
  out.set_text("", "estimator", name_of(analysis.options().estimator));
  out.set_numbers("", "averages", std::array{*std::min_element(averages.begin(), averages.end())}, false);
  out.commit();
}

}  // namespace percuss
