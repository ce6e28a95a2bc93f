#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "acquire/record.hpp"
#include "command_line.hpp"
#include "frf/frf_record.hpp"
#include "host.hpp"

namespace percuss::tools {

/// The options that say how recorded files are to be read; shared by analyze, frf, info and calibrate.
struct ReadFlags {
  std::vector<std::string> paths;
  ReadOptions options;
  std::string setup_path;                  // --setup CHANNELS.json
  FilesMean files = FilesMean::automatic;  // --files
  std::optional<FrfKind> frf_kind;         // --frf-kind
  bool trust_input = false;                // --trust-input
  // as typed, in the units of the option's name; turned into options by finish()
  std::vector<double> angle_deg;
  std::vector<double> position_m;
  std::optional<double> force_sensitivity_mV_per_N;
  std::vector<double> accel_sensitivity_mV_per_g;
  Host* host = nullptr;  // may give data in place of paths
};

enum class Reads { records, records_or_frfs };
void add_read_flags(Command& command, ReadFlags& flags, Reads reads = Reads::records_or_frfs);
// The parts of them: options on which a record's numbers depend, --setup, and --trust-input.
void add_reading_options(Command& command, ReadFlags& flags);
void add_setup_option(Command& command, ReadFlags& flags);
void add_trust_option(Command& command, ReadFlags& flags);
inline constexpr const char* kReadingHeading = "Reading";

/// The set-up file and typed units worked into flags.options. Throws InputError.
ReadOptions finished_options(const ReadFlags& flags);

/// The same for files of which each is opened by itself, whatever the flags name; UsageError for values per file.
FrfReadOptions options_of_each(const ReadFlags& flags);

/// One path opened with finished options.
Record open_record_at(const ReadFlags& flags, const ReadOptions& options, std::size_t index);

/// What the files hold: records of time or FRFs, never both.
struct Measurements {
  std::vector<Record> records;
  std::vector<FrfRecord> frfs;
};

/// Every path opened as what it is. InputError for records of time beside FRFs; UsageError as open_records.
Measurements open_measurements(const ReadFlags& flags);

/// One path opened as what it is, with finished options.
std::variant<Record, FrfRecord> open_measurement_at(const ReadFlags& flags, const ReadOptions& options,
                                                    std::size_t index);

/// Files of FRFs as one test: several are points. UsageError when --files says hits.
FrfRecord join_frfs_of(const ReadFlags& flags, std::vector<FrfRecord> frfs);

/// Every path opened; UsageError for none, or for one that is named twice; what several of them mean is the caller's
/// affair (join_records).
std::vector<Record> open_records(const ReadFlags& flags);

}  // namespace percuss::tools
