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

#include "acquire/record/sample_reader.hpp"
#include "core/error.hpp"

namespace percuss::acquire {

struct InputFile {
  std::string path;
  std::uint64_t bytes = 0;
};

/// One measured signal: how it is named and stored, and where its sensor sits.
struct SignalInfo {
  std::string name;                  // column or data set, or the name given in a channel set-up
  std::string unit;                  // as stored, for people ("g", "cm/s2"); empty: not stated
  double to_SI = 1;                  // stored value × to_SI = value in N or m/s²; carries sign and calibration
  std::optional<double> angle_rad;   // around the barrel
  std::optional<double> position_m;  // from the barrel's end
};

/// One stretch of continuously sampled time, all signals alike.
struct RowInfo {
  std::size_t samples = 0;
  std::size_t file = 0;  // index into Record::files
  int point = 0;         // which point was hit (or where the roving sensor sat)
  int run = 0;           // repeated test in one file
};

/// Where a signal's numbers lie in its file, one after the other: IEEE floats of 4 or 8 bytes, the lowest byte first.
struct ContiguousSignal {
  std::uint64_t offset_bytes = 0;    // of the first row's first number
  std::uint64_t row_step_bytes = 0;  // from row to row
  std::uint64_t number_bytes = 8;
  double to_SI = 1;
};

/// Two points that a drawing of the structure connects.
using TraceLine = std::array<int, 2>;

/// What was recorded, described without its samples: those are read when asked for, so that what nobody asks for is
/// never read. A row is one hit, unless there is just one row or `continuous` is set: then hits are searched within it.
struct Record {
  std::vector<InputFile> files;
  std::string format;  // for people: "HDF5", "CSV"
  double fs_Hz = 0;
  SignalInfo force;
  bool has_force = true;  // false: none was recorded, and read_force_N gives zeros
  std::vector<SignalInfo> accel;
  std::vector<RowInfo> rows;
  bool continuous = false;                    // every row may hold several hits
  std::vector<std::vector<double>> geometry;  // [points][2 or 3], as stored, NaN for points without; may be empty
  std::vector<TraceLine> trace_lines;         // may be empty
  std::vector<ContiguousSignal> contiguous;   // the force and each channel, where all lie plainly in one file
  std::vector<Message> notes;                 // what was assumed or could not be read, one line each
  /// The (first) file's path, or what it is where there is no file: names the record in messages.
  std::string source() const { return files.empty() ? format : files.front().path; }
  std::set<int> points() const;

  /// Samples first … first + out.size() − 1 of a row's force, in N. Several threads may call at once.
  SampleReader<std::size_t> read_force_N;  // (row, first, out)
  /// As above for an acceleration channel, in m/s².
  SampleReader<std::size_t, std::size_t> read_accel_mps2;  // (row, channel, first, out)
};

/// How one channel is connected, from a set-up file; empty members leave what the file says.
struct ChannelSetup {
  std::string name;  // the column's name or 1-based number, or the data set's channel ("accel 1")
  std::string role;  // "force", "acceleration" or "ignore"
  double sign = 1;   // −1 when the sensor points against its axis
  std::optional<double> angle_rad;
  std::optional<double> position_m;
  std::optional<double> sensitivity_V_per_SI;  // volts per N or per m/s²
  std::optional<std::string> unit;             // of the stored numbers
};

/// What the user says about a file; everything is optional and wins over what the file says.
struct ReadOptions {
  std::optional<double> fs_Hz;
  std::string fs_variable;                           // the rate's own variable, in files that name them (MAT)
  std::optional<double> df_Hz;                       // spacing of FRFs' lines, where the file does not state it
  std::string force_channel;                         // name or 1-based number of the column
  std::vector<std::string> accel_channels;           // likewise, in the order wanted
  std::vector<double> force_scale;                   // N per stored unit; one for all files or one per file
  std::vector<double> accel_scale;                   // m/s² per stored unit; one for all or one per channel
  std::optional<double> force_sensitivity_V_per_N;   // stored numbers are V (or mV by their unit)
  std::vector<double> accel_sensitivity_V_per_mps2;  // one for all or one per channel
  std::string force_unit, accel_unit;                // of the stored numbers
  std::vector<double> angle_rad, position_m;         // per acceleration channel
  std::vector<ChannelSetup> setup;
  bool force_optional = false;  // a file without a force is no error (MAT files excepted)
  bool sandboxed = false;       // read binary files of others' libraries in a process of its own (confined_process.hpp)
};

enum class FileGrouping { automatic, hits, points, tests };

/// Several files as one record: more hits of one test (same point), or one point each. Automatic is hits. Sampling
/// rates and the number and order of channels must agree. InputError names the file that differs. A single record
/// passes through unchanged.
Record join_records(std::vector<Record> records, FileGrouping mean);

/// The rows of `record` for which keep(row) holds, as a record of its own.
Record select_rows(const Record& record, const std::function<bool(const RowInfo&)>& keep);

/// Lines from numbers two by two: points from 0 up to `points` − 1.
/// errors  InputError at `where`: another count, or numbers that are no such points.
std::vector<TraceLine> trace_lines_of(const std::vector<double>& numbers, std::size_t points, const std::string& where);

/// What read_force_N is of a record without a force: zeros.
SampleReader<std::size_t> no_force();

/// A record whose samples are in memory: force [row][sample] in N, accel [row][channel][sample] in m/s².
Record record_in_memory(double fs_Hz, std::vector<std::vector<double>> force_N,
                        std::vector<std::vector<std::vector<double>>> accel_mps2);

}  // namespace percuss::acquire
