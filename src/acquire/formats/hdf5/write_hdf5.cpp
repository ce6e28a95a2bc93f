#include "acquire/formats/hdf5/write_hdf5.hpp"

#include <algorithm>
#include <array>

#include "acquire/formats/hdf5/hdf5_output.hpp"
#include "acquire/record/sensor_numbers.hpp"
#include "acquire/record/stated_date.hpp"
#include "acquire/record/trace_faces.hpp"
#include "acquire/record/writable_record.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kBlockSamples = std::size_t{1} << 17;  // 1 MiB at a time

// Copies samples block by block: read(first, out), then write(first, values).
template <class Read, class Write>
void copy_samples(std::size_t samples, Read&& read, Write&& write) {
  std::vector<double> block(std::min(samples, kBlockSamples));
  for (std::size_t first = 0; first < samples; first += block.size()) {
    const auto part = std::span(block).first(std::min(block.size(), samples - first));
    read(first, part);
    write(first, std::span<const double>(part));
  }
}

void write_samples(hdf5::OutputHdf5& out, const Record& record, bool one_row) {
  const std::size_t rows = record.rows.size(), channels = record.accel.size(), samples = record.rows[0].samples;
  const std::array shape{rows, channels, samples};
  if (record.has_force) out.create_set("force", one_row ? std::vector{samples} : std::vector{rows, samples});
  out.create_set("accel", std::span(shape).subspan(one_row ? 1 : 0));
  for (std::size_t row = 0; row < rows; ++row) {
    if (record.has_force) {
      copy_samples(
          samples, [&](std::size_t first, std::span<double> part) { record.read_force_N(row, first, part); },
          [&](std::size_t first, std::span<const double> values) {
            out.write("force", std::span(&row, one_row ? 0 : 1), first, values);
          });
    }
    for (std::size_t channel = 0; channel < channels; ++channel) {
      const std::array at{row, channel};
      copy_samples(
          samples,
          [&](std::size_t first, std::span<double> part) { record.read_accel_mps2(row, channel, first, part); },
          [&](std::size_t first, std::span<const double> values) {
            out.write("accel", std::span(at).subspan(one_row ? 1 : 0), first, values);
          });
    }
  }
}

// Writes the positions and angles of the sensors as attributes of /accel, NaN where unknown; nothing when all are
// unknown.
void write_sensors(hdf5::OutputHdf5& out, const Record& record) {
  const auto position_m = sensor_numbers(record.accel, &SignalInfo::position_m);
  const auto angle_deg = sensor_numbers(record.accel, &SignalInfo::angle_rad, kRadian_deg);
  if (!position_m.empty()) out.set_numbers("accel", "position_m", position_m, true);
  if (!angle_deg.empty()) out.set_numbers("accel", "angle_deg", angle_deg, true);
}

void write_row_numbers(hdf5::OutputHdf5& out, const Record& record, const std::string& name, int RowInfo::*number) {
  std::vector<double> values;
  for (const RowInfo& row : record.rows) values.push_back(row.*number);
  if (std::all_of(values.begin(), values.end(), [](double value) { return value == 0; })) return;
  out.create_set(name, std::array{values.size()}, hdf5::Stored::int32);
  out.write(name, {}, 0, values);
}

void write_marks(hdf5::OutputHdf5& out, const Record& record) {
  std::vector<double> marks;
  for (const RowInfo& row : record.rows) marks.push_back(static_cast<int>(row.mark));
  if (std::all_of(marks.begin(), marks.end(), [](double mark) { return mark == 0; })) return;
  out.create_set("rejected", std::array{marks.size()}, hdf5::Stored::int32);
  out.write("rejected", {}, 0, marks);
}

void write_faults(hdf5::OutputHdf5& out, const Record& record) {
  if (record.faults.empty()) return;
  out.create_set("faults", std::array{record.faults.size(), std::size_t{4}});
  for (std::size_t i = 0; i < record.faults.size(); ++i) {
    const RecordFault& fault = record.faults[i];
    out.write("faults", std::array{i}, 0,
              std::array{static_cast<double>(static_cast<int>(fault.kind)), static_cast<double>(fault.row),
                         fault.time_s, fault.value});
  }
}

void write_geometry(hdf5::OutputHdf5& out, const Record& record) {
  if (record.geometry.empty()) return;
  out.create_set("geometry", std::array{record.geometry.size(), record.geometry.front().size()});
  for (std::size_t point = 0; point < record.geometry.size(); ++point) {
    out.write("geometry", std::array{point}, 0, record.geometry[point]);
  }
}

void write_trace_lines(hdf5::OutputHdf5& out, const Record& record) {
  if (record.trace_lines.empty()) return;
  out.create_set("trace_lines", std::array{record.trace_lines.size(), std::size_t{2}}, hdf5::Stored::int32);
  std::size_t line = 0;
  for (const auto& [from, to] : record.trace_lines)
    out.write("trace_lines", std::array{line++}, 0, std::array{static_cast<double>(from), static_cast<double>(to)});
}

void write_trace_faces(hdf5::OutputHdf5& out, const Record& record) {
  if (record.trace_faces.empty()) return;
  const FaceTable table = face_table(record.trace_faces);
  out.create_set("trace_faces", std::array{record.trace_faces.size(), table.width}, hdf5::Stored::int32);
  for (std::size_t face = 0; face < record.trace_faces.size(); ++face)
    out.write("trace_faces", std::array{face}, 0, std::span(table.numbers).subspan(face * table.width, table.width));
}

}  // namespace

void write_hdf5(const std::string& path, const Record& record, bool force) {
  require_equal_lengths(record, path);
  hdf5::OutputHdf5 out(path, force);
  const bool one_row = record.continuous && record.rows.size() == 1;
  write_samples(out, record, one_row);
  out.set_numbers("", "fs", std::array{record.fs_Hz}, false);
  if (record.continuous && !one_row) out.set_numbers("", "continuous", std::array{1.0}, false);
  if (const std::string date = common_date_of(record.files); !date.empty()) out.set_text("", "date", date);
  if (record.has_force) out.set_text("force", "unit_str", "N");
  out.set_text("accel", "unit_str", si_name(record.accel.front().measures));
  write_sensors(out, record);
  write_row_numbers(out, record, "point", &RowInfo::point);
  write_row_numbers(out, record, "run", &RowInfo::run);
  write_marks(out, record);
  write_faults(out, record);
  write_geometry(out, record);
  write_trace_lines(out, record);
  write_trace_faces(out, record);
  out.commit();
}

}  // namespace percuss::acquire
