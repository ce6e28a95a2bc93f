#include "acquire/formats/uff/read_uff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <set>
#include <utility>

#include "acquire/channels/signal_table.hpp"
#include "acquire/formats/uff/uff_rows.hpp"
#include "core/error.hpp"
#include "core/io/time_stamps.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

struct OpenUff {
  FileBytes file;  // binary functions point into its bytes
  UffContents contents;
  std::vector<UffRow> rows;
};

std::optional<Quantity> quantity_of_axis(const UffAxis& axis) {
  const auto unit = parse_unit(axis.unit);
  if (unit && (unit->quantity == Quantity::force || unit->quantity == Quantity::acceleration)) return unit->quantity;
  if (axis.quantity == Uff58::excitation_force || axis.quantity == Uff58::reaction_force) return Quantity::force;
  if (axis.quantity == Uff58::acceleration) return Quantity::acceleration;
  return std::nullopt;
}

// Names of a row's functions, made unique.
std::vector<std::string> names_of_row(const UffRow& row) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const UffFunction* function : row) {
    std::string name = uff_dof_name(function->response);
    if (seen.contains(name)) name += " " + uff_dof_name({"", function->response.node, function->response.direction});
    for (int again = 2; seen.contains(name); ++again)
      name = uff_dof_name(function->response) + fmt::format(" #{}", again);
    seen.insert(name);
    names.push_back(std::move(name));
  }
  return names;
}

bool is_force_function(const UffFunction& function, const ReadOptions& options) {
  if (!options.force_channel.empty()) return uff_dof_name(function.response) == options.force_channel;
  for (const ChannelSetup& entry : options.setup) {
    if (entry.role == "force" && entry.name == uff_dof_name(function.response)) return true;
  }
  return quantity_of_axis(function.ordinate) == Quantity::force;
}

TableSignal signal_of(const UffFunction& function, const std::string& name, const std::optional<UffUnits>& units) {
  TableSignal out{.name = name};
  if (parse_unit(function.ordinate.unit)) out.unit = function.ordinate.unit;
  out.measures = quantity_of_axis(function.ordinate);
  if (units && out.measures) out.to_SI = 1 / (*out.measures == Quantity::force ? units->force : units->length);
  const UffAnnotation stated = uff_annotation(function);
  if (stated.angle_deg) out.angle_rad = *stated.angle_deg * kDegree_rad;
  out.position_m = stated.position_m;
  return out;
}

// The point of a row: the node of a roving sensor. Otherwise the struck point: the reference node, else the node of the
// force.
int point_of_row(const UffRow& row, bool sensor_roves) {
  const int offset = uff_annotation(*row.front()).node_offset;
  const UffFunction& last = *row.back();
  if (sensor_roves) return last.response.node - offset;
  const int node = last.reference.node != 0 ? last.reference.node : row.front()->response.node;
  return std::max(node, offset) - offset;
}

bool roving_sensor(const std::vector<UffRow>& rows) {
  std::set<int> struck, sensed;
  for (const UffRow& row : rows) {
    if (row.size() != 2) return false;
    struck.insert(row[1]->reference.node);
    struck.insert(row[0]->response.node);
    sensed.insert(row[1]->response.node);
  }
  return sensed.size() > 1 && struck.size() <= 2 && sensed.size() == rows.size();
}

double rate_of_function_Hz(const UffFunction& function, const std::string& where, std::string& note) {
  if (function.even) {
    const double dt_s = uff_step(function, false, note);
    if (dt_s > 0 && std::isfinite(dt_s)) return 1 / dt_s;
    throw InputError(fmt::format("a time step of {} s", function.dx), where, "state the sampling rate", {"fs"});
  }
  std::vector<double> times(function.count);
  double largest = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    times[i] = function.x(i);
    largest = std::max(largest, std::abs(times[i]));
  }
  StampProblem problem;
  // Times have five digits in a text and single precision in binary.
  const double resolution_s =
      largest * (function.bytes.empty() ? 1e-5 : 2 * static_cast<double>(std::numeric_limits<float>::epsilon()));
  const std::vector<TimeStamps> rows{{.time_s = times, .resolution_s = resolution_s}};
  const auto rate = rate_of_time_stamps(rows, problem);
  if (!rate) {
    throw InputError(fmt::format("{}, value {}", problem.text, problem.at + 1), where, "state the sampling rate",
                     {"fs"});
  }
  note = rate->note;
  return rate->fs_Hz;
}

std::string list_of_sets(const UffContents& contents) {
  std::string out;
  for (const auto& [number, count] : contents.sets)
    out += fmt::format("{}{} ({})", out.empty() ? "" : ", ", number, count);
  return out.empty() ? "no data sets" : "data sets " + out;
}

}  // namespace

bool is_time_record(const UffFunction& function) {
  return !function.complex &&
         (function.type == Uff58::time_response || (function.type == 0 && function.abscissa.quantity == Uff58::time));
}

bool is_uff_frf(const UffFunction& function) {
  return function.type == Uff58::frequency_response ||
         (function.type == 0 && function.complex && function.abscissa.quantity == Uff58::frequency);
}

std::string uff_set_list(const UffContents& contents) { return list_of_sets(contents); }

std::string uff_dof_name(const UffDof& dof) {
  if (!dof.name.empty()) return dof.name;
  const int direction = std::abs(dof.direction);
  const std::string sign = dof.direction < 0 ? "-" : "+";
  if (direction < 1 || direction > 6) return fmt::format("node {}", dof.node);
  constexpr std::array axes{"X", "Y", "Z", "RX", "RY", "RZ"};
  return fmt::format("{}{}{}", dof.node, sign, axes.at(static_cast<std::size_t>(direction - 1)));
}

Record open_uff(const FileBytes& file, UffContents contents, const ReadOptions& options) {
  auto open = std::make_shared<OpenUff>();
  open->file = file;
  open->contents = std::move(contents);
  const std::string name = input_name(file.path);
  std::vector<const UffFunction*> functions;
  std::vector<bool> is_force;
  for (const UffFunction& function : open->contents.functions) {
    if (!is_time_record(function)) continue;
    functions.push_back(&function);
    is_force.push_back(is_force_function(function, options));
  }
  if (functions.empty()) {
    const auto& all = open->contents.functions;
    if (std::any_of(all.begin(), all.end(), [](const UffFunction& function) { return is_uff_frf(function); })) {
      throw InputError("the file holds FRFs, not a time record", name,
                       "give the time record that the FRFs were estimated from");
    }
    const bool shapes = open->contents.shapes > 0;
    throw InputError("no time records and no FRFs among " + list_of_sets(open->contents), name,
                     shapes ? "the file holds mode shapes; give the time record that they were identified from"
                            : "export functions as data set 58");
  }
  open->rows = uff_rows(functions, is_force, name);
  SignalTable table;
  table.files.push_back({.path = file.path, .bytes = file.size});
  table.format = "UFF";
  table.notes = uff_notes(open->contents);
  const UffRow& first = open->rows.front();
  const auto names = names_of_row(first);
  for (std::size_t i = 0; i < first.size(); ++i)
    table.signals.push_back(signal_of(*first[i], names[i], open->contents.units));
  const bool sensor = roving_sensor(open->rows);
  const UffAnnotation stated = uff_annotation(*first.front());
  for (const UffRow& row : open->rows) {
    table.rows.push_back({.samples = row.front()->count,
                          .point = point_of_row(row, sensor),
                          .run = stated.by_percuss ? row.front()->load_case : 0});
  }
  table.geometry = uff_geometry(open->contents, stated.node_offset, table.notes);
  if (!table.geometry.empty()) table.trace_lines = uff_trace_lines(open->contents, stated.node_offset);
  std::string note;
  if (!options.fs_Hz) table.fs_Hz = rate_of_function_Hz(*first.front(), uff_location(file, first.front()->at), note);
  if (!note.empty()) table.notes.emplace_back(note, std::vector<OptionId>{"fs"});
  table.continuous = stated.by_percuss ? stated.continuous : table.rows.size() == 1;
  table.read = [open](std::size_t row, std::size_t signal, std::size_t start, std::span<double> out) {
    open->rows[row][signal]->read(0, start, out);
  };
  return record_of_table(std::move(table), options);
}

Record open_uff(const FileBytes& file, const ReadOptions& options) {
  return open_uff(file, read_uff_contents(file), options);
}

}  // namespace percuss::acquire
