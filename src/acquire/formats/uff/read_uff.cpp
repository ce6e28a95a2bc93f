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

#include "acquire/channels/axis_unit.hpp"
#include "acquire/channels/csv_columns.hpp"
#include "acquire/channels/signal_table.hpp"
#include "acquire/formats/uff/uff_roles.hpp"
#include "acquire/formats/uff/uff_rows.hpp"
#include "acquire/record/point_number.hpp"
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

TableSignal signal_of(const UffFunction& function, const std::string& name, const std::optional<UffUnits>& units) {
  TableSignal out{.name = name};
  if (parse_unit(function.ordinate.unit)) out.unit = function.ordinate.unit;
  if (out.unit.empty() && function.ordinate.quantity == Uff58::velocity) out.unit = si_name(Quantity::velocity);
  out.measures = quantity_of_axis(function.ordinate);
  if (units && out.measures) out.to_SI = 1 / (*out.measures == Quantity::force ? units->force : units->length);
  const UffAnnotation stated = uff_annotation(function);
  if (stated.angle_deg) out.angle_rad = *stated.angle_deg * kDegree_rad;
  out.position_m = stated.position_m;
  return out;
}

// The point of a row: the node of a roving sensor. Otherwise the struck point: the reference node, else the node of the
// force.
int point_of_row(const UffRow& row, bool sensor_roves, const FileBytes& file) {
  const int offset = uff_annotation(*row.front()).node_offset;
  const UffFunction& last = *row.back();
  const int struck = last.reference.node != 0 ? last.reference.node : row.front()->response.node;
  // Node 0 means that no node is stated: the row then belongs to the first point.
  const int point = (sensor_roves ? last.response.node : struck == 0 ? offset : struck) - offset;
  require_point_number(point, uff_location(file, row.front()->at));
  return point;
}

// The place of the hammer: the reference of a response, else the force's own.
const UffDof& struck_place(const UffRow& row, const UffFunction& response) {
  return response.reference.node != 0 ? response.reference : row.front()->response;
}

// The responses of a row that were measured where and in the direction in which it was struck.
void add_driving_places(const UffRow& row, int point, std::vector<DrivingPlace>& driving) {
  for (std::size_t i = 1; i < row.size(); ++i) {
    const DrivingPlace at{point, i};
    const bool known = std::find(driving.begin(), driving.end(), at) != driving.end();
    if (!known && same_place(row[i]->response, struck_place(row, *row[i]))) driving.push_back(at);
  }
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
  const double to_s = s_per_unit(function.abscissa.unit).value_or(1);
  if (function.even) {
    const double dt_s = uff_step(function, false, to_s, note) * to_s;
    if (dt_s > 0 && std::isfinite(dt_s)) return 1 / dt_s;
    throw InputError(fmt::format("a time step of {} s", dt_s), where, "state the sampling rate", {"fs"});
  }
  std::vector<double> times(function.count);
  double largest = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    times[i] = function.x(i) * to_s;
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

std::size_t number_of(const UffFunction* function, const std::vector<const UffFunction*>& functions) {
  return static_cast<std::size_t>(std::find(functions.begin(), functions.end(), function) - functions.begin()) + 1;
}

// Without a force all functions are signals of one row, so that the guess lists the functions of every hit. If they
// make rows of the guessed force and its responses, the numbers of the first row's functions replace the guess.
void guess_one_row(const std::vector<const UffFunction*>& functions, const std::vector<std::string>& names,
                   const std::string& file, RoleGuess& guess) {
  const auto by_name = std::find(names.begin(), names.end(), guess.force);
  const std::size_t force = by_name != names.end()
                                ? static_cast<std::size_t>(by_name - names.begin())
                                : static_cast<std::size_t>(std::strtoul(guess.force.c_str(), nullptr, 10)) - 1;
  if (force >= functions.size()) return;
  const ReadOptions by_number{.force_channel = std::to_string(force + 1)};
  const ReadOptions named = with_names(by_number, functions);
  if (named.force_channel == by_number.force_channel) return;
  try {
    const std::vector<UffRow> rows = uff_rows(functions, force_functions(functions, named), file);
    guess.force = std::to_string(number_of(rows.front().front(), functions));
    guess.accel.clear();
    for (std::size_t i = 1; i < rows.front().size(); ++i)
      guess.accel.push_back(std::to_string(number_of(rows.front()[i], functions)));
  } catch (const InputError&) {
  }
}

// "data sets 15 (1), 58 (3)".
std::string list_of_sets(const UffContents& contents) {
  std::string out;
  for (const auto& [number, count] : contents.sets)
    out += fmt::format("{}{} ({})", out.empty() ? "" : ", ", number, count);
  return out.empty() ? "no data sets" : "data sets " + out;
}

// "power spectral densities (PSD): 3, cross spectra: 1" of the functions; empty for none.
std::string spectra_in(const std::vector<UffFunction>& functions) {
  constexpr std::array<std::pair<int, const char*>, 5> kSpectra{
      {{Uff58::auto_spectrum, "auto spectra"},
       {Uff58::cross_spectrum, "cross spectra"},
       {Uff58::power_spectral_density, "power spectral densities (PSD)"},
       {Uff58::energy_spectral_density, "energy spectral densities (ESD)"},
       {Uff58::spectrum, "spectra"}}};
  std::string out;
  for (const auto& [type, what] : kSpectra) {
    std::size_t count = 0;
    for (const UffFunction& function : functions) count += function.type == type ? 1U : 0U;
    if (count > 0) out += fmt::format("{}{}: {}", out.empty() ? "" : ", ", what, count);
  }
  return out;
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

Record open_uff(const FileBytes& file, UffContents contents, const ReadOptions& options) {
  auto open = std::make_shared<OpenUff>();
  open->file = file;
  open->contents = std::move(contents);
  const std::string name = input_name(file.path);
  std::vector<UffFunction*> named_by_lines;
  for (UffFunction& function : open->contents.functions) {
    if (is_time_record(function)) named_by_lines.push_back(&function);
  }
  name_by_id_lines(named_by_lines);
  const std::vector<const UffFunction*> functions(named_by_lines.begin(), named_by_lines.end());
  if (functions.empty()) {
    const auto& all = open->contents.functions;
    if (std::any_of(all.begin(), all.end(), [](const UffFunction& function) { return is_uff_frf(function); })) {
      throw InputError("the file holds FRFs, not a time record", name,
                       "give the time record that the FRFs were estimated from");
    }
    if (const auto spectra = spectra_in(all); !spectra.empty()) {
      throw InputError("neither time records nor FRFs, but " + spectra, name,
                       "these functions are no FRFs: give the time record, or FRFs (function type 4)");
    }
    const bool shapes = open->contents.shapes > 0;
    throw InputError("no time records and no FRFs among " + list_of_sets(open->contents), name,
                     shapes ? "the file holds mode shapes; give the time record that they were identified from"
                            : "export functions as data set 58");
  }
  const ReadOptions named = with_names(options, functions);
  open->rows = uff_rows(functions, force_functions(functions, named), name);
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
                          .point = point_of_row(row, sensor, file),
                          .run = stated.by_percuss ? row.front()->load_case : 0});
    add_driving_places(row, table.rows.back().point, table.driving);
  }
  table.geometry = uff_geometry(open->contents, stated.node_offset, table.notes);
  if (!table.geometry.empty()) {
    table.trace_lines = uff_trace_lines(open->contents, stated.node_offset);
    table.trace_faces = uff_trace_faces(open->contents, stated.node_offset);
  }
  std::string note;
  if (!options.fs_Hz) table.fs_Hz = rate_of_function_Hz(*first.front(), uff_location(file, first.front()->at), note);
  if (!note.empty()) table.notes.emplace_back(note, std::vector<OptionId>{"fs"});
  table.continuous = stated.by_percuss ? stated.continuous : table.rows.size() == 1;
  table.read = [open](std::size_t row, std::size_t signal, std::size_t start, std::span<double> out) {
    open->rows[row][signal]->read(0, start, out);
  };
  try {
    return record_of_table(std::move(table), named);
  } catch (AmbiguousColumns& error) {
    if (open->rows.size() == 1 && !error.known.has_force) guess_one_row(functions, names, name, error.guess);
    throw;
  }
}

Record open_uff(const FileBytes& file, const ReadOptions& options) {
  return open_uff(file, read_uff_contents(file), options);
}

}  // namespace percuss::acquire
