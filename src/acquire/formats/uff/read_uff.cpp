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
#include "acquire/formats/uff/uff_directions.hpp"
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

TableSignal signal_of(const UffFunction& function, const std::string& name, const UffContents& contents) {
  const std::optional<UffUnits>& units = contents.units;
  TableSignal out{.name = name};
  if (parse_unit(function.ordinate.unit)) out.unit = function.ordinate.unit;
  if (out.unit.empty() && function.ordinate.quantity == Uff58::velocity) out.unit = si_name(Quantity::velocity);
  out.measures = quantity_of_axis(function.ordinate);
  if (units && out.measures) out.to_SI = 1 / (*out.measures == Quantity::force ? units->force : units->length);
  const UffAnnotation stated = uff_annotation(function);
  if (stated.angle_deg) out.angle_rad = *stated.angle_deg * kDegree_rad;
  out.position_m = stated.position_m;
  // The directions of percuss stand for the angles of its sensors.
  if (!stated.by_percuss) out.axis = uff_axis(contents, function.response);
  return out;
}

// The place and direction of the hammer: the reference of a response, completed by the force's own.
UffDof struck_place(const UffFunction& force, const UffFunction& response) {
  if (response.reference.node == 0) return force.response;
  UffDof out = response.reference;
  if (out.direction == 0 && out.node == force.response.node) out.direction = force.response.direction;
  return out;
}

UffDof struck_place(const UffRow& row) { return struck_place(*row.front(), *row.back()); }

// The node and unsigned direction of each row's force.
std::set<std::pair<int, int>> struck_in(const std::vector<UffRow>& rows) {
  std::set<std::pair<int, int>> out;
  for (const UffRow& row : rows) {
    const UffDof at = struck_place(row);
    out.emplace(at.node, std::abs(at.direction));
  }
  return out;
}

// The point of a row: the node of a roving sensor. Otherwise the struck point: the reference node, else the node of the
// force.
int point_of_row(const UffRow& row, bool sensor_roves, const UffStruckPoints& points, const FileBytes& file) {
  const int offset = uff_annotation(*row.front()).node_offset;
  const UffDof struck = struck_place(row);
  // Node 0 means that no node is stated: the row then belongs to the first point.
  const int place = sensor_roves ? row.back()->response.node : struck.node == 0 ? offset : struck.node;
  const std::int64_t point = (sensor_roves ? 0 : points.point(struck) - struck.node) + place - offset;
  require_point_number(place - offset, uff_location(file, row.front()->at));
  require_point_number(point, uff_location(file, row.front()->at));
  return static_cast<int>(point);
}

// The responses of a row that were measured where and in the direction in which it was struck.
void add_driving_places(const UffRow& row, int point, std::vector<DrivingPlace>& driving) {
  for (std::size_t i = 1; i < row.size(); ++i) {
    const DrivingPlace at{point, i};
    const bool known = std::find(driving.begin(), driving.end(), at) != driving.end();
    if (!known && same_place(row[i]->response, struck_place(*row.front(), *row[i]))) driving.push_back(at);
  }
}

// Whether one place was struck in one direction, and the sensors of a row, all at one node, moved.
bool roving_sensors(const std::vector<UffRow>& rows, const std::set<std::pair<int, int>>& struck) {
  std::set<int> sensed;
  for (const UffRow& row : rows) {
    if (row.size() < 2) return false;
    for (std::size_t i = 1; i < row.size(); ++i) {
      if (row[i]->response.node != row[1]->response.node) return false;
    }
    sensed.insert(row[1]->response.node);
  }
  return sensed.size() > 1 && struck.size() == 1;
}

// Where one place was struck, a row's sensors at several nodes must be at the same nodes in every row: a channel cannot
// be at several places of one point.
void require_fixed_sensors(const std::vector<UffRow>& rows, const std::string& file) {
  const UffRow& first = rows.front();
  for (std::size_t r = 1; r < rows.size(); ++r) {
    for (std::size_t i = 1; i < first.size(); ++i) {
      const int before = first[i]->response.node, now = rows[r][i]->response.node;
      if (before == now || before == 0 || now == 0) continue;
      throw InputError(
          fmt::format("response {} is at node {} in hit 1 and at node {} in hit {}", i, before, now, r + 1), file,
          "export the FRFs (function type 4): their response nodes are the points");
    }
  }
}

// What the file states of the places and directions of the struck points, or of roving sensors.
void add_motions(const UffContents& contents, const UffRow& row, int point, int offset, SignalTable& table) {
  if (!table.sensor_roves) {
    const UffDof struck = struck_place(row);
    const int place = struck.node == 0 ? 0 : struck.node - offset;
    return add_uff_motion(contents, struck, point, 0, place, table.motions);
  }
  for (std::size_t i = 1; i < row.size(); ++i)
    add_uff_motion(contents, row[i]->response, point, i, row[i]->response.node - offset, table.motions);
}

// The sign of a response for a force and a motion in positive directions.
double sign_in_row(const UffRow& row, const SignalRoles& roles, std::size_t signal) {
  const UffFunction& response = *row[signal];
  return uff_sign(response, roles.has_force ? struck_place(*row[roles.force], response) : UffDof{});
}

void note_changed_signs(const std::vector<UffRow>& rows, const SignalRoles& roles, std::vector<Message>& notes) {
  std::size_t changed = 0;
  for (const UffRow& row : rows) {
    for (const std::size_t signal : roles.accel) changed += sign_in_row(row, roles, signal) < 0 ? 1U : 0U;
  }
  if (changed > 0) notes.push_back(information(uff_sign_note(changed, rows.size() * roles.accel.size(), "responses")));
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

// The functions that are time records, named by their ID lines.
std::vector<const UffFunction*> time_records(UffContents& contents) {
  std::vector<UffFunction*> functions;
  for (UffFunction& function : contents.functions) {
    if (is_time_record(function)) functions.push_back(&function);
  }
  name_by_id_lines(functions);
  return {functions.begin(), functions.end()};
}

// Says what the file holds instead of time records.
[[noreturn]] void refuse_without_time_records(const UffContents& contents, const std::string& file) {
  const std::vector<UffFunction>& all = contents.functions;
  if (std::any_of(all.begin(), all.end(), [](const UffFunction& function) { return is_uff_frf(function); })) {
    throw InputError("the file holds FRFs, not a time record", file,
                     "give the time record that the FRFs were estimated from");
  }
  if (const auto spectra = spectra_in(all); !spectra.empty()) {
    throw InputError("neither time records nor FRFs, but " + spectra, file,
                     "these functions are no FRFs: give the time record, or FRFs (function type 4)");
  }
  throw InputError("no time records and no FRFs among " + list_of_sets(contents), file,
                   contents.shapes > 0
                       ? "the file holds mode shapes; give the time record that they were identified from"
                       : "export functions as data set 58");
}

// The rows with their points, driving points, places and directions.
void add_rows(const OpenUff& open, const UffAnnotation& stated, SignalTable& table) {
  const auto struck = struck_in(open.rows);
  const UffStruckPoints points(struck, open.contents);
  table.sensor_roves = roving_sensors(open.rows, struck);
  if (table.sensor_roves) {
    for (TableSignal& signal : table.signals) signal.axis.reset();
  } else if (struck.size() == 1) {
    require_fixed_sensors(open.rows, input_name(open.file.path));
  }
  if (points.several_per_node()) table.notes.push_back(information(points.note()));
  for (const UffRow& row : open.rows) {
    const int point = point_of_row(row, table.sensor_roves, points, open.file);
    table.rows.push_back(
        {.samples = row.front()->count, .point = point, .run = stated.by_percuss ? row.front()->load_case : 0});
    add_driving_places(row, point, table.driving);
    if (!stated.by_percuss) add_motions(open.contents, row, point, stated.node_offset, table);
  }
}

void add_sampling_rate(const UffFunction& function, const FileBytes& file, SignalTable& table) {
  std::string note;
  table.fs_Hz = rate_of_function_Hz(function, uff_location(file, function.at), note);
  if (!note.empty()) table.notes.emplace_back(note, std::vector<OptionId>{"fs"});
}

// The table of all rows. It keeps the open file for reading.
SignalTable table_of(const std::shared_ptr<OpenUff>& open, const std::vector<std::string>& names,
                     const ReadOptions& options) {
  const UffRow& first = open->rows.front();
  const UffAnnotation stated = uff_annotation(*first.front());
  SignalTable table;
  table.files.push_back({.path = open->file.path, .bytes = open->file.size});
  table.format = "UFF";
  table.notes = uff_notes(open->contents);
  for (std::size_t i = 0; i < first.size(); ++i)
    table.signals.push_back(signal_of(*first[i], names[i], open->contents));
  add_rows(*open, stated, table);
  if (!stated.by_percuss) {
    table.sign_of_directions = [open](const SignalRoles& roles, std::size_t row, std::size_t signal) {
      return sign_in_row(open->rows[row], roles, signal);
    };
  }
  add_uff_geometry(open->contents, stated.node_offset, table);
  if (!options.fs_Hz) add_sampling_rate(*first.front(), open->file, table);
  table.continuous = stated.by_percuss ? stated.continuous : table.rows.size() == 1;
  table.read = [open](std::size_t row, std::size_t signal, std::size_t start, std::span<double> out) {
    open->rows[row][signal]->read(0, start, out);
  };
  return table;
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
  const std::vector<const UffFunction*> functions = time_records(open->contents);
  if (functions.empty()) refuse_without_time_records(open->contents, name);
  const ReadOptions named = with_names(options, functions);
  open->rows = uff_rows(functions, force_functions(functions, named), name);
  const auto names = names_of_row(open->rows.front());
  SignalTable table = table_of(open, names, options);
  try {
    if (table.sign_of_directions) note_changed_signs(open->rows, find_roles(table, named), table.notes);
    return record_of_table(std::move(table), named);
  } catch (AmbiguousColumns& error) {
    if (open->rows.size() == 1 && !error.known.has_force && !error.roles_known)
      guess_one_row(functions, names, name, error.guess);
    throw;
  }
}

Record open_uff(const FileBytes& file, const ReadOptions& options) {
  return open_uff(file, read_uff_contents(file), options);
}

}  // namespace percuss::acquire
