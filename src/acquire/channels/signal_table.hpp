#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"
#include "core/io/csv_header.hpp"
#include "core/units.hpp"

namespace percuss::acquire {

/// One signal as a file describes it, before its role is known.
struct TableSignal {
  std::string name;
  std::string unit;  // empty: not stated
  std::optional<double> angle_rad, position_m;
  std::string shape;  // for messages, where the file holds arrays: "4096x1"
  // Quantity and factor, where the file states them by other means than a unit.
  std::optional<Quantity> measures{};
  std::optional<double> to_SI{};
  std::optional<Direction> axis{};
};

struct SignalRoles;

/// Signals sampled together, from the reader of any format. find_roles assigns the force and the accelerations by the
/// same rules for every format.
struct SignalTable {
  std::vector<InputFile> files;
  std::string format;
  double fs_Hz = 0;
  std::vector<TableSignal> signals;
  std::vector<RowInfo> rows;
  bool continuous = false;
  std::vector<std::vector<double>> geometry;
  std::vector<TraceLine> trace_lines;
  std::vector<TraceFace> trace_faces{};
  std::vector<DrivingPlace> driving{};  // with indices of signals in place of channels
  std::vector<PointMotion> motions{};   // likewise where the sensors roved
  bool sensor_roves = false;
  std::vector<Message> notes;
  /// Stored numbers first … first + out.size() − 1 of a row's signal. Several threads may call at once.
  std::function<void(std::size_t row, std::size_t signal, std::size_t first, std::span<double> out)> read;
  /// The sign, 1 or −1, of a row's acceleration for a force and a motion in positive directions, where the file states
  /// directions; may be empty.
  std::function<double(const SignalRoles& roles, std::size_t row, std::size_t signal)> sign_of_directions{};
};

/// Indices of the signals that are the force and the accelerations.
struct SignalRoles {
  std::size_t force = 0;
  bool has_force = true;  // false: `force` is not a signal
  std::vector<std::size_t> accel;
};

/// Finds the roles as find_csv_columns does: by the options' names or numbers, the set-up, the unit, words in the name.
/// A message lists the shape of an array in place of its unit.
/// errors  AmbiguousColumns, InputError: as there.
SignalRoles find_roles(const SignalTable& table, const ReadOptions& options);

/// The record of these signals. File, set-up and options determine units, signs, sensitivities and places.
/// errors  InputError: unusable units or rate, no rows, fewer than two samples in a row; the read functions throw it
/// for samples that are too large or not finite.
Record record_of_table(SignalTable table, const SignalRoles& roles, const ReadOptions& options);
/// As above, with the roles of find_roles. Adds a note if no force was found, but a signal looks like one.
Record record_of_table(SignalTable table, const ReadOptions& options);

}  // namespace percuss::acquire
