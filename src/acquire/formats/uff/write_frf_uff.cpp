#include <fmt/format.h>

#include "acquire/formats/uff/uff_trace_lines.hpp"
#include "acquire/formats/uff/write_frf_uff.hpp"
#include "acquire/formats/uff/write_uff.hpp"

namespace percuss::acquire {
namespace {

UffAxis motion_axis(FrfKind kind) {
  if (kind == FrfKind::mobility) return {Uff58::velocity, "Velocity", "m/s"};
  if (kind == FrfKind::receptance) return {Uff58::displacement, "Displacement", "m"};
  return {Uff58::acceleration, "Acceleration", "m/s^2"};
}

UffFunction described_frf(const FrfRecord& record, const PointFrf& frf, FrfKind kind, int offset) {
  const SignalInfo& sensor = record.accel[frf.channel];
  UffFunction out{.type = Uff58::frequency_response, .count = record.lines.count, .complex = true};
  out.id[0] = fmt::format("{} point {} channel {}", name_of(kind), frf.point, frf.channel);
  if (!record.estimator.empty()) out.id[1] = "estimator = " + record.estimator;
  out.id[3] = uff_sensor_text(sensor);
  if (frf.frf.averages > 0) out.id[3] += fmt::format("averages = {}; ", frf.frf.averages);
  if (record.decay_per_s > 0) out.id[3] += fmt::format("decay_per_s = {}; ", record.decay_per_s);
  out.id[4] = uff_annotation_text(offset, record.lines.df_Hz());
  out.response = {fmt::format("accel {}", frf.channel + 1), 0, uff_direction(sensor)};
  out.reference = {"force", frf.point + offset, 0};
  out.x0 = record.lines.freq_Hz(0);
  out.dx = record.lines.df_Hz();
  out.abscissa = {Uff58::frequency, "Frequency", "Hz"};
  out.ordinate = motion_axis(kind);
  out.denominator = {Uff58::excitation_force, "Force", "N"};
  return out;
}

}  // namespace

void write_frf_record_uff(const std::string& path, const FrfRecord& record, FrfKind kind, bool force, UffData data) {
  const int offset = uff_node_offset(record.frfs.front().point);
  UffOutput out(path, force, data);
  out.header();
  const std::string nodes = uff_node_lines(record.geometry, offset);
  if (!nodes.empty()) out.set(2411, nodes);
  for (const std::string& line : uff_trace_line_sets(uff_drawable_lines(record.geometry, record.trace_lines), offset))
    out.set(82, line);
  const std::string elements = uff_element_lines(uff_drawable_faces(record.geometry, record.trace_faces), offset);
  if (!elements.empty()) out.set(2412, elements);
  for (const PointFrf& frf : record.frfs) {
    const Frf shown = converted(frf.frf, record.lines, kind, record.decay_per_s);
    UffFunction function = described_frf(record, frf, kind, offset);
    std::vector<double> values;
    values.reserve(2 * shown.value.size());
    for (const Complex& value : shown.value) values.insert(values.end(), {value.real(), value.imag()});
    out.function(function, values);
    if (shown.coherence.empty()) continue;
    function.type = Uff58::coherence;
    function.complex = false;
    function.ordinate = {0, "Coherence", ""};
    function.denominator = {};
    out.function(function, shown.coherence);
  }
  out.commit();
}

}  // namespace percuss::acquire
