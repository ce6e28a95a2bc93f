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
#include "acquire/formats/uff/uff_row_points.hpp"
#include "acquire/formats/uff/uff_rows.hpp"
#include "acquire/record/note_on_rounding.hpp"
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
  // In a file that percuss wrote, a direction only states the angle of a sensor.
  if (!stated.by_percuss) out.axis = uff_axis(contents, function.response);
  return out;
}

double rate_of_function_Hz(const UffFunction& function, const std::string& where, UffStepNote& note) {
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
  note = {rate->note, largest_error_of(*rate)};
  return rate->fs_Hz;
}

std::size_t number_of(const UffFunction* function, const std::vector<const UffFunction*>& functions) {
  return static_cast<std::size_t>(std::find(functions.begin(), functions.end(), function) - functions.begin()) + 1;
}

// Without a force, all functions are signals of one row, so the guess lists the functions of all hits. If the guessed
// force divides the functions into rows, the guess becomes the functions of the first row, by their numbers.
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

void add_sampling_rate(const UffFunction& function, const FileBytes& file, SignalTable& table) {
  UffStepNote note;
  table.fs_Hz = rate_of_function_Hz(function, uff_location(file, function.at), note);
  if (!note.text.empty()) table.notes.push_back(note_on_rounding(note.text, note.largest_error, "fs"));
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
  add_uff_rows(open->rows, open->contents, open->file, table);
  if (!stated.by_percuss) {
    table.sign_of_directions = [open](const SignalRoles& roles, std::size_t row, std::size_t signal) {
      return uff_sign_in_row(open->rows[row], roles, signal);
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
    if (table.sign_of_directions) note_uff_signs(open->rows, find_roles(table, named), table.notes);
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
