#include "acquire/formats/uff/write_uff.hpp"

#include "acquire/formats/uff/uff_trace_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

#include "acquire/record/writable_record.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

bool has_place(const std::vector<double>& at) {
  return at.size() == 3 && std::all_of(at.begin(), at.end(), [](double x) { return std::isfinite(x); });
}

bool has_coordinates(const Record& record) { return !record.geometry.empty() && record.geometry.front().size() == 3; }

UffFunction described(const Record& record, const RowInfo& row, int offset) {
  UffFunction out{.type = Uff58::time_response, .load_case = row.run, .count = row.samples};
  out.id[4] = uff_annotation_text(offset, 1 / record.fs_Hz) + (record.continuous ? "; continuous" : "");
  out.reference.node = row.point + offset;
  out.dx = 1 / record.fs_Hz;
  out.abscissa = {Uff58::time, "Time", "s"};
  return out;
}

void write_row_functions(UffOutput& out, const Record& record, std::size_t row, int offset) {
  const RowInfo& info = record.rows[row];
  UffFunction function = described(record, info, offset);
  function.id[0] = fmt::format("hit {}", row + 1);
  if (record.has_force) {
    function.response = {"force", info.point + offset, 0};
    function.ordinate = {Uff58::excitation_force, "Force", "N"};
    out.function_of(function, info.samples,
                    [&](std::size_t first, std::span<double> part) { record.read_force_N(row, first, part); });
  }
  for (std::size_t c = 0; c < record.accel.size(); ++c) {
    function.response = {fmt::format("accel {}", c + 1), 0, uff_direction(record.accel[c])};
    function.ordinate = is_pressure(record.accel[c]) ? UffAxis{Uff58::pressure, "Pressure", "Pa"}
                                                     : UffAxis{Uff58::acceleration, "Acceleration", "m/s^2"};
    function.id[3] = uff_sensor_text(record.accel[c]);
    out.function_of(function, info.samples,
                    [&](std::size_t first, std::span<double> part) { record.read_accel_mps2(row, c, first, part); });
  }
}

// The lines or faces whose points all have coordinates.
template <class Points>
std::vector<Points> drawable(const std::vector<std::vector<double>>& geometry, const std::vector<Points>& all) {
  const auto is_node = [&](int point) {
    const auto row = static_cast<std::size_t>(point);
    return point >= 0 && row < geometry.size() && has_place(geometry[row]);
  };
  std::vector<Points> out;
  std::copy_if(all.begin(), all.end(), std::back_inserter(out),
               [&](const Points& each) { return std::all_of(each.begin(), each.end(), is_node); });
  return out;
}

}  // namespace

int uff_node_offset(int lowest_point) { return lowest_point < 1 ? 1 : 0; }

int uff_direction(const SignalInfo& sensor) {
  if (!sensor.angle_rad) return 1;
  const double quarter = *sensor.angle_rad / (90 * kDegree_rad);
  if (std::abs(quarter - std::round(quarter)) > 1e-6 || std::abs(quarter) > 8) return 1;
  constexpr std::array directions{2, 3, -2, -3};
  return directions.at((static_cast<std::size_t>(std::lround(quarter) + 8)) % 4);
}

std::string uff_annotation_text(int node_offset, double dx) {
  return fmt::format("percuss{}; dx = {}", node_offset == 1 ? "; node = point + 1" : "", dx);
}

std::string uff_sensor_text(const SignalInfo& sensor) {
  std::string out;
  if (sensor.angle_rad) out += fmt::format("angle_deg = {:.10g}; ", *sensor.angle_rad * kRadian_deg);
  if (sensor.position_m) out += fmt::format("position_m = {:.10g}; ", *sensor.position_m);
  return out;
}

std::vector<TraceLine> uff_drawable_lines(const std::vector<std::vector<double>>& geometry,
                                          const std::vector<TraceLine>& lines) {
  return drawable(geometry, lines);
}

std::vector<TraceFace> uff_drawable_faces(const std::vector<std::vector<double>>& geometry,
                                          const std::vector<TraceFace>& faces) {
  std::vector<TraceFace> out = drawable(geometry, faces);
  std::erase_if(out, [](const TraceFace& face) { return !is_uff_element(face); });
  return out;
}

std::string uff_node_lines(const std::vector<std::vector<double>>& geometry, int node_offset) {
  std::string out;
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    const auto& at = geometry[i];
    if (!has_place(at)) continue;
    out += fmt::format("{:10}{:10}{:10}{:10}\n{}{}{}\n", i + static_cast<std::size_t>(node_offset), 0, 0, 11,
                       uff_d25(at[0]), uff_d25(at[1]), uff_d25(at[2]));
  }
  return out;
}

void write_uff(const std::string& path, const Record& record, bool force, UffData data) {
  require_contents(record, path);
  const std::set<int> points = record.points();
  const int offset = uff_node_offset(*points.begin());
  UffOutput out(path, force, data);
  out.header();
  if (has_coordinates(record)) {
    const std::string lines = uff_node_lines(record.geometry, offset);
    if (!lines.empty()) out.set(2411, lines);
  }
  for (const std::string& line : uff_trace_line_sets(uff_drawable_lines(record.geometry, record.trace_lines), offset))
    out.set(82, line);
  const std::string elements = uff_element_lines(uff_drawable_faces(record.geometry, record.trace_faces), offset);
  if (!elements.empty()) out.set(2412, elements);
  for (std::size_t row = 0; row < record.rows.size(); ++row) write_row_functions(out, record, row, offset);
  out.commit();
}

}  // namespace percuss::acquire
