#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "acquire/record/point_motion.hpp"
#include "acquire/record/row_mark.hpp"
#include "acquire/record/sample_reader.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace percuss::acquire {

struct InputFile {
  std::string path;
  std::uint64_t bytes = 0;
  std::string date{};  // of the recording, where its reader found one; see date_of()
};

/// One measured signal: its name, its unit as stored, and the place of its sensor.
struct SignalInfo {
  std::string name;                  // of the column, the data set or the channel set-up's entry
  std::string unit;                  // as stored, for people ("g", "cm/s2"); empty: not stated
  bool unit_assumed = false;         // `unit` is not stated in the file
  double to_SI = 1;                  // stored value × to_SI = value in N, m/s² or Pa; carries sign and calibration
  std::optional<double> angle_rad;   // around the barrel
  std::optional<double> position_m;  // from the barrel's end
  std::optional<Direction> axis{};   // of a positive value, where the file or the channel set-up states it
  Quantity measures = Quantity::acceleration;  // force, acceleration, or the pressure at a microphone
};

/// Whether the signal comes from a microphone, in Pa.
inline bool is_pressure(const SignalInfo& signal) { return signal.measures == Quantity::pressure; }

/// A range of time in which all signals were sampled without a gap, except for the missing samples in Record::faults.
struct RowInfo {
  std::size_t samples = 0;
  std::size_t file = 0;          // index into Record::files
  int point = 0;                 // the point that was hit, or the place of a roving sensor
  int run = 0;                   // repeated test in one file
  RowMark mark = RowMark::none;  // rejected while it was recorded
};

/// A point struck beside the sensor of a channel, in the direction of the sensor.
struct DrivingPlace {
  int point = 0;
  std::size_t channel = 0;  // index into Record::accel
  bool operator==(const DrivingPlace&) const = default;
};

/// The driving places at the chosen channels, which are numbered anew in the order of `channels`.
std::vector<DrivingPlace> driving_at(const std::vector<DrivingPlace>& driving,
                                     const std::vector<std::size_t>& channels);

/// The storage of a signal whose numbers are contiguous in its file: little-endian IEEE floats of 4 or 8 bytes.
struct ContiguousSignal {
  std::uint64_t offset_bytes = 0;    // of the first number of the first row
  std::uint64_t row_step_bytes = 0;  // from row to row
  std::uint64_t number_bytes = 8;
  double to_SI = 1;
};

/// Two points that drawings of the structure connect by a line.
using TraceLine = std::array<int, 2>;
/// The corners of a face in drawings, in order around it: three points or more.
using TraceFace = std::vector<int>;

/// The description of a measurement over time. Samples are read on request only. A row is one hit, unless there is only
/// one row or `continuous` is set: then each row is searched for hits.
struct Record {
  std::vector<InputFile> files;
  std::string format;  // for people: "HDF5", "CSV"
  double fs_Hz = 0;
  SignalInfo force;
  bool has_force = true;          // false: no force was recorded, and read_force_N gives zeros
  std::vector<SignalInfo> accel;  // the responses: accelerations, or pressures where no force was recorded
  std::vector<RowInfo> rows;
  bool continuous = false;  // every row may hold several hits
  // [points][x, y, z in m] or [points][position in m, angle in degrees]; NaN where not known; may be empty
  std::vector<std::vector<double>> geometry;
  std::vector<TraceLine> trace_lines;        // may be empty
  std::vector<TraceFace> trace_faces;        // may be empty
  std::vector<DrivingPlace> driving;         // where the file states them; may be empty
  std::vector<PointMotion> motions;          // likewise; ascending by point, then channel
  bool sensor_roves = false;                 // the file states that one place was struck, and that the sensors moved
  std::vector<ContiguousSignal> contiguous;  // the force and each channel, where all are contiguous; else empty
  std::vector<RecordFault> faults;           // faults while the record was captured, in order of time
  std::vector<Message> notes;                // assumptions, and parts that could not be read
  /// The first file's path, or the format where there is no file: the record's name in messages.
  std::string source() const { return files.empty() ? format : files.front().path; }
  std::set<int> points() const;

  /// Samples first … first + out.size() − 1 of a row's force, in N. Several threads may call at once.
  SampleReader<std::size_t> read_force_N;  // (row, first, out)
  /// As above for a response, in m/s² (Pa for a microphone).
  SampleReader<std::size_t, std::size_t> read_accel_mps2;  // (row, channel, first, out)
};

/// An entry of a channel set-up. Empty members leave what the record's file states.
struct ChannelSetup {
  std::string name;                 // name or 1-based number of the column, or "accel 1", "force"
  std::string role;                 // "force", "acceleration" or "ignore"
  double sign = 1;                  // −1 when the sensor points against its axis
  std::optional<Direction> axis{};  // x, y or z, where a direction is stated
  std::optional<double> angle_rad, position_m;
  std::optional<double> sensitivity_V_per_SI;        // volts per N, m/s² or Pa
  Quantity sensitivity_to = Quantity::acceleration;  // what these volts measure
  std::optional<std::string> unit;                   // of the stored numbers
};

/// The user's statements about a file. Each is optional and overrides the file's own.
struct ReadOptions {
  std::optional<double> fs_Hz;
  std::string fs_variable;                  // the variable that holds the rate, in formats with named variables (MAT)
  std::optional<double> df_Hz;              // spacing of the FRFs' lines, where the file lacks or rounds it
  std::string force_channel;                // name or 1-based number of the column, or path of a data set
  std::vector<std::string> accel_channels;  // likewise, in the order wanted
  std::vector<double> force_scale;          // N per stored unit; one for all files or one per file
  std::vector<double> accel_scale;          // m/s² per stored unit; one for all or one per channel
  std::optional<double> force_sensitivity_V_per_N;    // stored numbers are V (or mV by their unit)
  std::vector<double> accel_sensitivity_V_per_mps2;   // one for all or one per channel
  std::vector<double> pressure_sensitivity_V_per_Pa;  // likewise, of microphones
  std::string force_unit, accel_unit;                 // of the stored numbers
  std::vector<double> angle_rad, position_m;          // per acceleration channel
  std::vector<ChannelSetup> setup;
  bool force_optional = false;  // accept a file without a force
  bool sandboxed = false;       // decode foreign binary files in a child process (sandbox_process.hpp)
};

enum class FileGrouping { automatic, hits, points, tests };

/// Joins several files to one record. With `hits`, point numbers stay, so that files without point numbers are hits of
/// one point. With `points`, the points of a file follow the points of the file before it. `automatic` means hits. A
/// single record is returned unchanged. A caller that keeps files apart (`tests`) must not join them.
/// errors  InputError: no records; sampling rates or channel counts differ, or only some files have a force; files of
/// `hits` state different directions for one point; names the file.
Record join_records(std::vector<Record> records, FileGrouping grouping);

/// A record of the rows for which keep(row) is true.
Record select_rows(const Record& record, const std::function<bool(const RowInfo&)>& keep);

/// Checks `number`, the end of a line or the corner of a face, and returns it as a point number, 0 … `points` − 1.
/// `what` ("line", "face") is for the message.
/// errors  InputError at `where`: it is not the number of a point
int geometry_point(double number, std::size_t points, const char* what, const std::string& where);

/// Lines from pairs of point numbers, 0 … `points` − 1.
/// errors  InputError at `where`: an odd count, or a number that is not a point's.
std::vector<TraceLine> trace_lines_of(const std::vector<double>& numbers, std::size_t points, const std::string& where);

/// A reader of zeros: the force of a record without one.
SampleReader<std::size_t> no_force();

/// A record of samples in memory: force [row][sample] in N, accel [row][channel][sample] in m/s².
Record record_in_memory(double fs_Hz, std::vector<std::vector<double>> force_N,
                        std::vector<std::vector<std::vector<double>>> accel_mps2);

}  // namespace percuss::acquire
