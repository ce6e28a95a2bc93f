#include "acquire/formats/mat/write_mat.hpp"

#include <algorithm>

#include "acquire/formats/mat/mat_output.hpp"
#include "acquire/formats/mat/mat_sensors.hpp"
#include "acquire/record/trace_faces.hpp"
#include "acquire/record/writable_record.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kNumbersAtOnce = std::size_t{1} << 19U;  // 4 MiB of samples, transposed so that hits run fastest

// Appends a matrix [series, samples] column by column; read(s, first, out) reads samples of series s.
template <class Read>
void write_interleaved(MatOutput& out, std::size_t series_count, std::size_t samples, Read&& read) {
  const std::size_t at_once = std::max<std::size_t>(1, std::min(samples, kNumbersAtOnce / series_count));
  std::vector<double> series(at_once), columns(at_once * series_count);
  for (std::size_t first = 0; first < samples; first += at_once) {
    const std::size_t count = std::min(at_once, samples - first);
    for (std::size_t s = 0; s < series_count; ++s) {
      read(s, first, std::span(series).first(count));
      for (std::size_t i = 0; i < count; ++i) columns[i * series_count + s] = series[i];
    }
    out.append(std::span<const double>(columns).first(count * series_count));
  }
}

void write_row_number(MatOutput& out, const Record& record, const char* name, int RowInfo::*number) {
  std::vector<double> values;
  for (const RowInfo& row : record.rows) values.push_back(row.*number);
  if (std::any_of(values.begin(), values.end(), [](double value) { return value != 0; })) out.numbers(name, values);
}

void write_geometry_rows(MatOutput& out, const Record& record) {
  if (record.geometry.empty()) return;
  const std::size_t width = record.geometry.front().size();
  out.begin("geometry", std::array{record.geometry.size(), width});
  for (std::size_t i = 0; i < width; ++i) {
    for (const auto& point : record.geometry) out.append(std::span(&point.at(i), 1));
  }
}

void write_trace_lines(MatOutput& out, const Record& record) {
  if (record.trace_lines.empty()) return;
  out.begin("trace_lines", std::array{record.trace_lines.size(), std::size_t{2}});
  for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
    for (const TraceLine& line : record.trace_lines) out.append(std::array{static_cast<double>(line.at(end))});
  }
}

void write_trace_faces(MatOutput& out, const Record& record) {
  if (record.trace_faces.empty()) return;
  const std::size_t faces = record.trace_faces.size();
  const FaceTable table = face_table(record.trace_faces);
  out.begin("trace_faces", std::array{faces, table.width});
  for (std::size_t corner = 0; corner < table.width; ++corner) {
    for (std::size_t face = 0; face < faces; ++face)
      out.append(std::span(table.numbers).subspan(face * table.width + corner, 1));
  }
}

}  // namespace

void write_mat(const std::string& path, const Record& record, bool force) {
  require_equal_lengths(record, path);
  const std::size_t rows = record.rows.size(), channels = record.accel.size(), samples = record.rows[0].samples;
  MatOutput out(path, force);
  out.number("fs", record.fs_Hz);
  if (record.has_force) {
    out.begin("force", std::array{rows, samples});
    write_interleaved(out, rows, samples, [&](std::size_t row, std::size_t first, std::span<double> part) {
      record.read_force_N(row, first, part);
    });
    out.text("force_unit", "N");
  }
  // Time is last: MATLAB would drop a trailing dimension of 1.
  out.begin("accel", std::array{rows, channels, samples});
  write_interleaved(out, rows * channels, samples, [&](std::size_t series, std::size_t first, std::span<double> part) {
    record.read_accel_mps2(series % rows, series / rows, first, part);
  });
  out.text("accel_unit", si_name(record.accel.front().measures));
  write_mat_sensors(out, record.accel);
  write_row_number(out, record, "point", &RowInfo::point);
  write_row_number(out, record, "run", &RowInfo::run);
  if (record.continuous != (rows == 1)) out.number("continuous", record.continuous ? 1 : 0);
  write_geometry_rows(out, record);
  write_trace_lines(out, record);
  write_trace_faces(out, record);
  out.commit();
}

}  // namespace percuss::acquire
