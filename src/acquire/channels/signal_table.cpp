#include "acquire/channels/signal_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "acquire/channels/csv_columns.hpp"
#include "acquire/channels/role_guess.hpp"
#include "acquire/channels/signal_overrides.hpp"
#include "acquire/channels/unit_notes.hpp"
#include "acquire/record/sample_limits.hpp"
#include "acquire/record/sampling_rate.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {
namespace {

std::string table_name(const SignalTable& table) {
  return table.files.empty() ? table.format : input_name(table.files.front().path);
}

// "g" of "acc_g"; nothing for brackets without a unit, as in "data(:,2)".
std::string unit_in_name(const std::string& name) {
  std::string unit = split_name(name).unit;
  return parse_unit(unit) ? unit : "";
}

CsvColumn column_of(const SignalTable& table, std::size_t index) {
  const TableSignal& signal = table.signals[index];
  const NameAndUnit parts = split_name(signal.name);
  CsvColumn column{.index = index, .name = signal.name, .base = parts.base, .unit = signal.unit};
  if (column.unit.empty()) column.unit = unit_in_name(signal.name);
  if (column.unit.empty() && signal.measures) column.unit = si_name(*signal.measures);
  return column;
}

CsvHeader header_of(const SignalTable& table) {
  CsvHeader header{.named = true, .text = false};
  if (table.fs_Hz > 0) header.fs_Hz = table.fs_Hz;
  for (std::size_t i = 0; i < table.signals.size(); ++i) {
    header.columns.push_back(column_of(table, i));
    header.columns.back().shape = table.signals[i].shape;
  }
  return header;
}

struct ScaledTable {
  SignalTable table;
  SignalRoles roles;
  double force_to_N = 1;
  std::vector<double> accel_to_mps2;
};

void read_table(const ScaledTable& open, std::size_t row, std::size_t signal, double factor, std::size_t first,
                std::span<double> out) {
  open.table.read(row, signal, first, out);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] *= factor;
    if (std::abs(out[i]) <= kMaxSample) continue;
    throw InputError(std::isfinite(out[i]) ? "sample is too large" : "sample is not a finite number",
                     fmt::format("{}: {}, row {}, sample {}", table_name(open.table),
                                 one_line(open.table.signals[signal].name, 40), row, first + i),
                     "repair or leave out this hit");
  }
}

SignalInfo described_signal(const SignalTable& table, std::size_t index) {
  const TableSignal& signal = table.signals[index];
  // If the file states the scale of the numbers, the unit in the name does not apply to them.
  const std::string unit = signal.unit.empty() && !signal.to_SI ? unit_in_name(signal.name) : signal.unit;
  return {.name = signal.name,
          .unit = unit,
          .angle_rad = signal.angle_rad,
          .position_m = signal.position_m,
          .axis = signal.axis};
}

// Completes a signal without a stated unit: takes the scale of the file's own system of units, or assumes SI where the
// file states none. Returns whether SI is assumed.
bool complete_unit(const SignalInfo& signal, const TableSignal& stored, SignalOverrides& choice) {
  if (states_scale(signal, choice)) return false;
  choice.scale = stored.to_SI;
  return !stored.to_SI;
}

void describe_table(ScaledTable& open, const ReadOptions& options, Record& record) {
  const SignalTable& table = open.table;
  const auto place = [&](const SignalInfo& signal) { return table_name(table) + ": " + signal.name; };
  record.has_force = open.roles.has_force;
  double sign = 1;  // of the responses
  if (record.has_force) {
    const ChannelSetup* const setup = setup_of(column_of(table, open.roles.force), options);
    sign = response_sign(setup);
    record.force = described_signal(table, open.roles.force);
    SignalOverrides choice = force_overrides(options, setup);
    const bool assumed = complete_unit(record.force, table.signals[open.roles.force], choice);
    apply_force_overrides(record.force, choice, place(record.force), record.notes);
    if (assumed) mark_unit_assumed(record.force);
    open.force_to_N = record.force.to_SI;
  }
  const std::size_t count = open.roles.accel.size();
  for (std::size_t c = 0; c < count; ++c) {
    const std::size_t index = open.roles.accel[c];
    SignalInfo signal = described_signal(table, index);
    SignalOverrides choice =
        accel_overrides(options, setup_of(column_of(table, index), options), c, count, table_name(table));
    choice.sign *= sign;
    const bool stated_pressure = !record.has_force && signal.unit.empty() && choice.unit.empty() &&
                                 table.signals[index].measures == Quantity::pressure;
    const bool assumed = complete_unit(signal, table.signals[index], choice);
    const Quantity measures =
        stated_pressure ? Quantity::pressure : response_quantity(signal, choice, record.has_force);
    apply_overrides(signal, choice, measures, place(signal));
    if (assumed) mark_unit_assumed(signal);
    open.accel_to_mps2.push_back(signal.to_SI);
    record.accel.push_back(std::move(signal));
  }
  note_assumed_units(record);
}

std::vector<double> first_samples(const SignalTable& table, std::size_t index, std::size_t max_samples) {
  std::vector<double> samples(table.rows.empty() ? 0 : std::min(table.rows.front().samples, max_samples));
  table.read(0, index, 0, samples);
  return samples;
}

// From the samples of the first row.
RoleGuess guess_of(const SignalTable& table, const CsvHeader& header, const CsvColumns& known,
                   const ReadOptions& options) {
  return guess_roles(header.columns, known, options,
                     [&](std::size_t index, std::size_t max) { return first_samples(table, index, max); });
}

std::optional<Message> unread_hammer_note(const SignalTable& table, const SignalRoles& roles) {
  if (!table.read) return std::nullopt;
  CsvColumns known{.has_force = roles.has_force};
  std::vector<CsvColumn> columns;
  for (std::size_t i = 0; i < table.signals.size(); ++i) columns.push_back(column_of(table, i));
  for (const std::size_t index : roles.accel) known.accel.push_back(columns[index]);
  return unread_hammer_note(columns, known,
                            [&](std::size_t index, std::size_t max) { return first_samples(table, index, max); });
}

}  // namespace

SignalRoles find_roles(const SignalTable& table, const ReadOptions& options) {
  const CsvHeader header = header_of(table);
  try {
    const CsvColumns found = find_csv_columns(header, options, table_name(table));
    SignalRoles roles{.force = found.force.index, .has_force = found.has_force, .accel = {}};
    for (const CsvColumn& column : found.accel) roles.accel.push_back(column.index);
    return roles;
  } catch (AmbiguousColumns& error) {
    error.format = table.format;
    if (table.read) error.guess = guess_of(table, header, error.known, options);
    error.guess.rate_known = table.fs_Hz > 0 || options.fs_Hz.has_value() || !options.fs_variable.empty();
    if (error.guess.rate_known) error.guess.assumed_rate_Hz = 0;
    // The user chooses among arrays by their sizes.
    for (CsvColumn& column : error.columns) {
      if (!column.shape.empty()) column.unit = column.shape;
    }
    throw;
  }
}

Record record_of_table(SignalTable table, const SignalRoles& roles, const ReadOptions& options) {
  auto open = std::make_shared<ScaledTable>();
  Record record;
  record.notes = std::move(table.notes);
  record.geometry = std::move(table.geometry);
  record.trace_lines = std::move(table.trace_lines);
  record.trace_faces = std::move(table.trace_faces);
  record.driving = driving_at(table.driving, roles.accel);
  record.sensor_roves = table.sensor_roves;
  record.motions = table.sensor_roves ? motions_at(table.motions, roles.accel) : std::move(table.motions);
  sort_motions(record.motions);
  record.files = table.files;
  record.format = table.format;
  record.rows = table.rows;
  record.continuous = table.continuous;
  open->table = std::move(table);
  open->roles = roles;
  const std::string where = table_name(open->table);
  record.fs_Hz = checked_rate_Hz(options.fs_Hz.value_or(open->table.fs_Hz), where);
  if (options.fs_Hz) note_other_rate("the file", open->table.fs_Hz, record.fs_Hz, record.notes);
  try {
    describe_table(*open, options, record);
  } catch (const InputError& error) {
    throw_with_columns_if_unscaled(error, header_of(open->table), record.format);
    throw;
  }
  if (record.rows.empty()) throw InputError("no samples", where, "record at least one hit");
  for (const RowInfo& row : record.rows) {
    if (row.samples < 2) throw InputError("fewer than two samples in a row", where, "record for longer");
  }
  record.read_force_N = [open](std::size_t row, std::size_t first, std::span<double> out) {
    read_table(*open, row, open->roles.force, open->force_to_N, first, out);
  };
  if (!record.has_force) record.read_force_N = no_force();
  record.read_accel_mps2 = [open](std::size_t row, std::size_t channel, std::size_t first, std::span<double> out) {
    const std::size_t signal = open->roles.accel.at(channel);
    const auto& sign = open->table.sign_of_directions;
    const double factor = open->accel_to_mps2.at(channel) * (sign ? sign(open->roles, row, signal) : 1);
    read_table(*open, row, signal, factor, first, out);
  };
  return record;
}

Record record_of_table(SignalTable table, const ReadOptions& options) {
  const SignalRoles roles = find_roles(table, options);
  if (const auto note = unread_hammer_note(table, roles)) table.notes.push_back(*note);
  return record_of_table(std::move(table), roles, options);
}

}  // namespace percuss::acquire
