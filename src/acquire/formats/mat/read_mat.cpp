#include "acquire/formats/mat/read_mat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string_view>
#include <utility>

#include "acquire/channels/column_words.hpp"
#include "acquire/channels/csv_columns.hpp"
#include "acquire/channels/signal_table.hpp"
#include "acquire/formats/mat/mat_channels.hpp"
#include "acquire/formats/mat/mat_description.hpp"
#include "acquire/formats/mat/mat_guess.hpp"
#include "acquire/formats/mat/mat_layout.hpp"
#include "acquire/formats/mat/mat_rate.hpp"
#include "acquire/record/point_number.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

using ChannelMap = std::map<std::string, MatChannel>;

// The unit that the file states for a variable; for a channel, the unit of the variable that held it.
std::string stated_unit(const MatFile& file, const MatVariable& variable, const ChannelMap& split) {
  const auto channel = split.find(variable.name);
  return unit_in(file, channel == split.end() ? variable.name : channel->second.variable);
}

// The unit in a variable's name: "g" of "acc_g", also for its channel "acc_g 2".
std::string unit_in_variable_name(const std::string& name, const ChannelMap& split) {
  const auto channel = split.find(name);
  return split_name(channel == split.end() ? name : channel->second.variable).unit;
}

// Lists each variable as one signal, to find the roles. lay_out divides variables into channels.
SignalTable variables_of(const MatFile& file, const ChannelMap& split, std::vector<std::size_t>& index) {
  SignalTable table;
  table.files.push_back({.path = file.path, .bytes = file.bytes});
  table.format = "MAT";
  for (std::size_t v = 0; v < file.variables.size(); ++v) {
    if (!may_be_signal(file.variables[v])) continue;
    const MatVariable& variable = file.variables[v];
    table.signals.push_back({.name = variable.name, .unit = stated_unit(file, variable, split)});
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
    const std::size_t typed = std::strtoul(name.c_str() + bracket + 3, nullptr, 10);
    const std::size_t before = matrix != nullptr ? matrix->columns_taken : 0;
    const std::size_t column = typed - std::min(typed, before);
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
  std::erase_if(out.accel_channels, [&](const auto& name) { return find_variable(file, name) == nullptr; });
  return out;
}

SignalRoles roles_of(const SignalTable& table, const MatFile& file, const std::vector<std::size_t>& index,
                     const ReadOptions& options) {
  try {
    return find_roles(table, variable_options(file, options));
  } catch (AmbiguousColumns& error) {
    const bool rate_known = error.guess.rate_known;
    error.guess = guess_mat_roles(file, index, error.known, variable_options(file, options));
    error.guess.rate_known = rate_known;
    throw;
  }
}

struct OpenMat {
  MatFile file;
  struct Source {
    std::size_t variable;
    MatSignal signal;
  };
  std::vector<Source> sources;  // [signals]
};

void require_real(const MatVariable& variable, const std::string& file) {
  if (variable.is_complex())
    throw InputError(one_line(variable.name, 63) + " is complex", file, "save the samples of a record as real numbers");
}

// The layout of a record without a force. If a variable holds several channels and nothing says that they are
// responses, one of them could be the force: the roles are then ambiguous.
MatLayout layout_without_force(OpenMat& open, const SignalRoles& roles, const std::vector<std::size_t>& index,
                               const ReadOptions& options, SignalTable& table) {
  const MatVariable& first = open.file.variables[index[roles.accel.front()]];
  const TableSignal& signal = table.signals[roles.accel.front()];
  const MatLayout layout = response_layout(first, stated_hits(open.file, first.name), open.file.path);
  const bool one_row = first.shape.size() == 2 && layout.rows == 1 && first.size() > layout.samples;
  if (!one_row) return layout;
  const auto unit = parse_unit(signal.unit.empty() ? split_name(signal.name).unit : signal.unit);
  const bool measures_response = unit && is_response(unit->quantity);
  const bool named = !options.accel_channels.empty() || !options.setup.empty();
  if (!named && !measures_response && quantity_named(signal.name) != Quantity::acceleration) {
    CsvHeader header{.named = true, .text = false};
    header.columns.push_back({.index = 0, .name = first.name, .base = first.name, .unit = shape_name(first.shape)});
    AmbiguousColumns error(fmt::format("one of the channels of {} ({}) could be the force", one_line(first.name, 40),
                                       shape_name(first.shape)),
                           open.file.path,
                           "name the variable as accelerations, or save the force as a variable of its own", header,
                           {"force_channel", "accel_channel"});
    error.format = table.format;
    error.guess = guess_mat_roles(open.file, index, {}, {});
    error.guess.rate_known = true;
    throw error;
  }
  table.notes.push_back(information(fmt::format("{} is {}: taken as {} channels of one row", one_line(first.name, 40),
                                                shape_name(first.shape), first.size() / layout.samples)));
  return layout;
}

// The name of the force, else of the first response. The fields beside this variable describe the record.
const std::string& name_beside(const OpenMat& open, const SignalRoles& roles, const std::vector<std::size_t>& index) {
  return open.file.variables[index[roles.has_force ? roles.force : roles.accel.front()]].name;
}

// Sets the angles and positions of the accelerations. The file states them for all channels of a variable. If one
// channel is the force, the acceleration that takes its place in the list has the channel's angle and position.
void place_signals(const OpenMat& open, std::size_t first_accel, const ChannelMap& split,
                   std::vector<TableSignal>& signals, std::vector<Message>& notes) {
  const auto name_of = [&](std::size_t signal) { return open.file.variables[open.sources[signal].variable].name; };
  const std::string beside = name_of(0);
  const std::size_t accels = signals.size() - first_accel;
  std::size_t whole = 0;  // accelerations that are no channels of a split variable
  for (std::size_t c = 0; c < accels; ++c) whole += split.contains(name_of(first_accel + c)) ? 0U : 1U;
  const auto as_force = first_accel == 0 || whole != 1 ? split.end() : split.find(name_of(0));
  for (std::size_t c = 0; c < accels; ++c) {
    TableSignal& signal = signals[first_accel + c];
    const auto own = split.find(name_of(first_accel + c));
    const bool instead = own == split.end() && as_force != split.end();
    const auto& stated = instead ? as_force : own;
    const MatChannel place = stated == split.end() ? MatChannel{.channel = c, .channels = accels} : stated->second;
    const auto angle_deg = per_channel(open.file, "angle_deg", place.channels, beside)[place.channel];
    if (angle_deg) signal.angle_rad = *angle_deg * kDegree_rad;
    signal.position_m = per_channel(open.file, "position_m", place.channels, beside)[place.channel];
    if (instead && (signal.angle_rad || signal.position_m)) {
      notes.emplace_back(fmt::format("{} has the angle and the position that the file states for {}, which is the "
                                     "force here",
                                     one_line(signal.name, 40), one_line(as_force->first, 40)),
                         std::vector<OptionId>{"angle", "position"});
    }
  }
}

// Signal 0 is the force, if there is one; the channels of each acceleration follow.
void lay_out(OpenMat& open, const SignalRoles& roles, const std::vector<std::size_t>& index, const ReadOptions& options,
             const ChannelMap& split, SignalTable& table) {
  std::vector<TableSignal> signals;
  MatLayout layout;
  if (roles.has_force) {
    const MatVariable& force = open.file.variables[index[roles.force]];
    require_real(force, open.file.path);
    layout = force_layout(force, open.file.path);
    signals.push_back(table.signals[roles.force]);
    open.sources.push_back({index[roles.force], layout.signal});
  } else {
    layout = layout_without_force(open, roles, index, options, table);
  }
  const std::string beside = name_beside(open, roles, index);
  const std::size_t first_accel = signals.size();
  for (const std::size_t role : roles.accel) {
    const MatVariable& variable = open.file.variables[index[role]];
    require_real(variable, open.file.path);
    const auto channels = accel_layout(variable, layout, open.file.path);
    const std::string unit = table.signals[role].unit;
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const bool one = channels.size() == 1 && variable.name != "accel";
      signals.push_back({.name = variable.name + (one ? "" : fmt::format(" {}", c + 1)), .unit = unit});
      const std::string own_unit = unit_in_variable_name(variable.name, split);
      if (unit.empty() && parse_unit(own_unit)) signals.back().unit = own_unit;
      open.sources.push_back({index[role], channels[c]});
    }
  }
  place_signals(open, first_accel, split, signals, table.notes);
  table.signals = std::move(signals);
  const std::vector<int> point = numbers_of_hits(open.file, "point", layout.rows, beside, table.notes);
  const std::vector<int> run = numbers_of_hits(open.file, "run", layout.rows, beside, table.notes);
  for (std::size_t row = 0; row < layout.rows; ++row) {
    table.rows.push_back({.samples = layout.samples, .point = point[row], .run = run[row]});
    require_point_number(table.rows.back().point, open.file.path + ": point");
  }
  table.continuous = mat_number(open.file, {"continuous"}).value_or(layout.rows == 1 ? 1 : 0) != 0;
}

// The accelerations to read: the channels that the options name or number ("accel 2", "2"). If the options name
// nothing, or only variables: all channels that the set-up does not ignore.
SignalRoles chosen_roles(const SignalTable& table, const MatFile& file, const ReadOptions& options, bool has_force) {
  SignalRoles roles{.has_force = has_force, .accel = {}};
  const std::size_t first = has_force ? 1 : 0;
  const bool variables_only = std::all_of(options.accel_channels.begin(), options.accel_channels.end(),
                                          [&](const auto& name) { return find_variable(file, name) != nullptr; });
  for (std::size_t i = first; i < table.signals.size(); ++i) {
    const auto ignored = [&](const ChannelSetup& s) {
      return s.role == "ignore" && lower_case(s.name) == lower_case(table.signals[i].name);
    };
    if (!variables_only || std::any_of(options.setup.begin(), options.setup.end(), ignored)) continue;
    roles.accel.push_back(i);
  }
  for (const std::string& name : options.accel_channels) {
    if (variables_only) break;
    std::size_t found = table.signals.size();
    for (std::size_t i = first; i < table.signals.size(); ++i) {
      if (lower_case(table.signals[i].name) == lower_case(name) || name == std::to_string(i + 1 - first)) found = i;
    }
    if (found == table.signals.size() ||
        std::find(roles.accel.begin(), roles.accel.end(), found) != roles.accel.end()) {
      throw InputError(fmt::format("channel \"{}\" does not exist or is requested twice, among {} channels",
                                   one_line(name, 40), table.signals.size() - first),
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
  const ChannelMap split = split_channels(open->file, options);
  std::vector<std::size_t> index;
  SignalTable table = variables_of(open->file, split, index);
  table.notes = open->file.notes;
  const auto rate_Hz = mat_rate_Hz(open->file, options);
  table.fs_Hz = rate_Hz.value_or(0);
  if (table.signals.empty())
    throw InputError("no arrays of numbers", open->file.path, "save force and accelerations as arrays");
  if (!rate_Hz) refuse_spectral_densities(open->file);
  const SignalRoles variables = roles_of(table, open->file, index, options);
  if (!rate_Hz) {
    throw InputError("no sampling rate among the variables", open->file.path, "state it in Hz, or name its variable",
                     {"fs"});
  }
  lay_out(*open, variables, index, options, split, table);
  const std::string beside = name_beside(*open, variables, index);
  table.geometry = geometry_in(open->file, beside);
  take_connections(open->file, table, beside);
  const SignalRoles roles = chosen_roles(table, open->file, options, variables.has_force);
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
