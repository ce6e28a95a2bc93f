#include "acquire/formats/mat/read_mat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "acquire/channels/csv_columns.hpp"
#include "acquire/channels/signal_table.hpp"
#include "acquire/formats/mat/mat_layout.hpp"
#include "acquire/formats/mat/mat_rate.hpp"
#include "acquire/record/point_number.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

// Names of percuss's own layout that are not signals.
bool is_description(const std::string& name) {
  static const std::vector<std::string> kNames{"point",     "run",        "geometry",   "trace_lines",
                                               "angle_deg", "position_m", "continuous", "fs"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

bool may_be_signal(const MatVariable& variable) {
  return !variable.is_text && variable.size() > 1 && !is_description(lower_case(field_name(variable.name)));
}

std::string unit_in(const MatFile& file, const std::string& name) {
  for (const char* ending : {"_unit", "_units", "_unit_str"}) {
    const MatVariable* const stated = find_variable(file, name + ending);
    if (stated != nullptr && stated->is_text) return stated->text;
  }
  return {};
}

// Lists each variable as one signal, to find the roles. lay_out divides variables into channels.
SignalTable variables_of(const MatFile& file, std::vector<std::size_t>& index) {
  SignalTable table;
  table.files.push_back({.path = file.path, .bytes = file.bytes});
  table.format = "MAT";
  for (std::size_t v = 0; v < file.variables.size(); ++v) {
    if (!may_be_signal(file.variables[v])) continue;
    const MatVariable& variable = file.variables[v];
    table.signals.push_back({.name = variable.name, .unit = unit_in(file, variable.name)});
    table.signals.back().shape = shape_name(variable.shape) + (variable.is_complex() ? " complex" : "");
    index.push_back(v);
  }
  return table;
}

// Adds each matrix column that the options name as MATLAB does, "data(:,2)", as a variable.
void add_named_columns(MatFile& file, const ReadOptions& options) {
  std::vector<std::string> names = options.accel_channels;
  names.push_back(options.force_channel);
  for (const ChannelSetup& entry : options.setup) names.push_back(entry.name);
  for (const std::string& name : names) {
    const auto bracket = name.rfind("(:,");
    if (bracket == std::string::npos || find_variable(file, name) != nullptr) continue;
    const MatVariable* const matrix = find_variable(file, name.substr(0, bracket));
    const std::size_t column = std::strtoul(name.c_str() + bracket + 3, nullptr, 10);
    const bool has_columns = matrix != nullptr && !matrix->is_text && matrix->shape.size() == 2;
    if (!has_columns || column < 1 || column > matrix->shape[1]) continue;
    MatVariable taken{.name = name, .shape = {matrix->shape[0], 1}};
    const auto first = static_cast<std::ptrdiff_t>((column - 1) * matrix->shape[0]);
    const auto count = static_cast<std::ptrdiff_t>(matrix->shape[0]);
    taken.real.assign(matrix->real.begin() + first, matrix->real.begin() + first + count);
    if (matrix->is_complex())
      taken.imaginary.assign(matrix->imaginary.begin() + first, matrix->imaginary.begin() + first + count);
    file.variables.push_back(std::move(taken));
  }
}

// The options with the names of variables only. Other names are channels of a variable; chosen_roles applies them.
ReadOptions variable_options(const MatFile& file, const ReadOptions& options) {
  ReadOptions out = options;
  out.force_optional = false;  // the dimensions of the other arrays follow from the force's
  std::erase_if(out.accel_channels, [&](const auto& name) { return find_variable(file, name) == nullptr; });
  return out;
}

struct OpenMat {
  MatFile file;
  struct Source {
    std::size_t variable;
    MatSignal signal;
  };
  std::vector<Source> sources;  // [signals]
};

std::vector<std::optional<double>> per_channel(const MatFile& file, const char* name, std::size_t count) {
  std::vector<std::optional<double>> out(count);
  const MatVariable* const given = find_variable(file, name);
  if (given == nullptr || given->size() != count || given->is_complex()) return out;
  for (std::size_t c = 0; c < count; ++c) {
    if (std::isfinite(given->real[c])) out[c] = given->real[c];
  }
  return out;
}

int whole_number(const MatFile& file, const char* name, std::size_t row, std::size_t rows) {
  const MatVariable* const given = find_variable(file, name);
  if (given == nullptr || given->is_text) return 0;
  const auto is_whole = [](double x) { return std::abs(x) <= std::numeric_limits<int>::max() && std::rint(x) == x; };
  if (given->size() != rows || given->is_complex() || !is_whole(given->real[row])) {
    throw InputError(fmt::format("not one whole number for each of {} hits", rows), file.path + ": " + name,
                     "store one per hit");
  }
  return static_cast<int>(given->real[row]);
}

std::vector<std::vector<double>> geometry_in(const MatFile& file) {
  const MatVariable* const given = real_matrix(file, "geometry");
  if (given == nullptr || given->shape[1] < 2 || given->shape[1] > 3) return {};
  std::vector<std::vector<double>> out(given->shape[0]);
  for (std::size_t i = 0; i < given->size(); ++i) out[i % out.size()].push_back(given->real[i]);
  return out;
}

std::vector<TraceLine> trace_lines_in(const MatFile& file, std::size_t points) {
  const MatVariable* const given = real_matrix(file, "trace_lines");
  if (given == nullptr || given->shape[1] != 2) return {};
  std::vector<double> numbers;
  const std::size_t lines = given->shape[0];
  for (std::size_t i = 0; i < lines; ++i) numbers.insert(numbers.end(), {given->real[i], given->real[lines + i]});
  return trace_lines_of(numbers, points, file.path + ": trace_lines");
}

// Unreadable trace lines do not make the file an error: another program may use the name for something else.
void take_trace_lines(const MatFile& file, SignalTable& table) {
  try {
    table.trace_lines = trace_lines_in(file, table.geometry.size());
  } catch (const InputError&) {
    table.notes.emplace_back("trace_lines is not used: it refers to points without geometry");
  }
}

void require_real(const MatVariable& variable, const std::string& file) {
  if (variable.is_complex())
    throw InputError(one_line(variable.name, 63) + " is complex", file, "save the samples of a record as real numbers");
}

// Signal 0 is the force; the channels of each acceleration follow.
void lay_out(OpenMat& open, const SignalRoles& roles, const std::vector<std::size_t>& index, SignalTable& table) {
  const MatVariable& force = open.file.variables[index[roles.force]];
  require_real(force, open.file.path);
  const MatLayout layout = force_layout(force, open.file.path);
  std::vector<TableSignal> signals{table.signals[roles.force]};
  open.sources.push_back({index[roles.force], layout.signal});
  for (const std::size_t role : roles.accel) {
    const MatVariable& variable = open.file.variables[index[role]];
    require_real(variable, open.file.path);
    const auto channels = accel_layout(variable, layout, open.file.path);
    const std::string unit = table.signals[role].unit;
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const bool one = channels.size() == 1 && variable.name != "accel";
      signals.push_back({.name = variable.name + (one ? "" : fmt::format(" {}", c + 1)), .unit = unit});
      if (unit.empty() && parse_unit(split_name(variable.name).unit))
        signals.back().unit = split_name(variable.name).unit;
      open.sources.push_back({index[role], channels[c]});
    }
  }
  const std::size_t accels = signals.size() - 1;
  const auto angle_deg = per_channel(open.file, "angle_deg", accels);
  const auto position_m = per_channel(open.file, "position_m", accels);
  for (std::size_t c = 0; c < accels; ++c) {
    if (angle_deg[c]) signals[c + 1].angle_rad = *angle_deg[c] * kDegree_rad;
    signals[c + 1].position_m = position_m[c];
  }
  table.signals = std::move(signals);
  for (std::size_t row = 0; row < layout.rows; ++row) {
    table.rows.push_back({.samples = layout.samples,
                          .point = whole_number(open.file, "point", row, layout.rows),
                          .run = whole_number(open.file, "run", row, layout.rows)});
    require_point_number(table.rows.back().point, open.file.path + ": point");
  }
  table.continuous = mat_number(open.file, {"continuous"}).value_or(layout.rows == 1 ? 1 : 0) != 0;
}

// The accelerations to read: the channels that the options name or number ("accel 2", "2"). If the options name
// nothing, or only variables: all channels that the set-up does not ignore.
SignalRoles chosen_roles(const SignalTable& table, const MatFile& file, const ReadOptions& options) {
  SignalRoles roles;
  const bool variables_only = std::all_of(options.accel_channels.begin(), options.accel_channels.end(),
                                          [&](const auto& name) { return find_variable(file, name) != nullptr; });
  for (std::size_t i = 1; i < table.signals.size(); ++i) {
    const auto ignored = [&](const ChannelSetup& s) {
      return s.role == "ignore" && lower_case(s.name) == lower_case(table.signals[i].name);
    };
    if (!variables_only || std::any_of(options.setup.begin(), options.setup.end(), ignored)) continue;
    roles.accel.push_back(i);
  }
  for (const std::string& name : options.accel_channels) {
    if (variables_only) break;
    std::size_t found = 0;
    for (std::size_t i = 1; i < table.signals.size(); ++i) {
      if (lower_case(table.signals[i].name) == lower_case(name) || name == std::to_string(i)) found = i;
    }
    if (found == 0 || std::find(roles.accel.begin(), roles.accel.end(), found) != roles.accel.end()) {
      throw InputError(fmt::format("channel \"{}\" does not exist or is requested twice, among {} channels",
                                   one_line(name, 40), table.signals.size() - 1),
                       file.path, "give 1 for the first channel, or a channel's name");
    }
    roles.accel.push_back(found);
  }
  if (roles.accel.empty()) throw InputError("every acceleration is ignored", file.path, "keep one");
  return roles;
}

}  // namespace

Record open_mat(MatFile file, const ReadOptions& options) {
  auto open = std::make_shared<OpenMat>();
  open->file = std::move(file);
  add_named_columns(open->file, options);
  std::vector<std::size_t> index;
  SignalTable table = variables_of(open->file, index);
  table.notes = open->file.notes;
  const auto rate_Hz = mat_rate_Hz(open->file, options);
  table.fs_Hz = rate_Hz.value_or(0);
  if (table.signals.empty())
    throw InputError("no arrays of numbers", open->file.path, "save force and accelerations as arrays");
  const SignalRoles variables = find_roles(table, variable_options(open->file, options));
  if (!rate_Hz) {
    throw InputError("no sampling rate among the variables", open->file.path, "state it in Hz, or name its variable",
                     {"fs"});
  }
  lay_out(*open, variables, index, table);
  table.geometry = geometry_in(open->file);
  take_trace_lines(open->file, table);
  const SignalRoles roles = chosen_roles(table, open->file, options);
  std::vector<bool> used(open->file.variables.size(), false);
  for (const auto& source : open->sources) used[source.variable] = true;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) open->file.variables[v].real = open->file.variables[v].imaginary = std::vector<double>{};
  }
  table.read = [open](std::size_t row, std::size_t signal, std::size_t first, std::span<double> out) {
    const auto& [variable, places] = open->sources[signal];
    const std::vector<double>& values = open->file.variables[variable].real;
    const std::size_t start = places.offset + row * places.row_stride;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = values[start + (first + i) * places.sample_stride];
  };
  return record_of_table(std::move(table), roles, options);
}

}  // namespace percuss::acquire
