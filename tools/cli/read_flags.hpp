#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "acquire/record/frf_record.hpp"
#include "acquire/record/record.hpp"
#include "cli/command_line.hpp"
#include "cli/host.hpp"

namespace percuss::tools {

/// The reading options, shared by all commands that read records.
struct ReadFlags {
  std::vector<std::string> paths;
  acquire::ReadOptions options;
  std::string setup_path;                                          // --setup CHANNELS.json
  acquire::FileGrouping files = acquire::FileGrouping::automatic;  // --files
  std::optional<acquire::FrfKind> frf_kind;                        // --frf-kind
  std::optional<std::size_t> averages;                             // --averages
  bool trust_input = false;                                        // --trust-input
  // As typed, in the units of their names; resolved_read_options() converts them.
  std::vector<double> angle_deg;
  std::vector<double> position_m;
  std::optional<double> force_sensitivity_mV_per_N;
  std::vector<double> accel_sensitivity_mV_per_g, pressure_sensitivity_mV_per_Pa;
  Host* host = nullptr;  // may provide data in place of paths
};

/// What a command reads. `described`: records or FRFs, each file alone, so that --files has no effect.
enum class Reads { records, records_or_frfs, described };
void add_read_flags(Command& command, ReadFlags& flags, Reads reads = Reads::records_or_frfs);
// The parts of add_read_flags: options that change a record's numbers, --setup, and --trust-input.
void add_reading_options(Command& command, ReadFlags& flags);
void add_setup_option(Command& command, ReadFlags& flags);
void add_trust_input_option(Command& command, ReadFlags& flags);
inline constexpr const char* kReadingHeading = "Reading";

/// The options with the set-up file and the typed units applied. Throws InputError, and OptionError for a rate that is
/// no number, unless a MAT file is read.
acquire::ReadOptions resolved_read_options(const ReadFlags& flags);

/// The options for one of several files, with its own force scale. Throws UsageError for a wrong number of scales.
acquire::ReadOptions read_options_of_file(const acquire::ReadOptions& all, std::size_t index, std::size_t files);

/// The options of one file with the statements about FRFs.
acquire::FrfReadOptions frf_read_options(const ReadFlags& flags, const acquire::ReadOptions& options);

/// Resolved options for files that are opened one by one. Throws UsageError for an option with a value per file.
acquire::FrfReadOptions per_file_read_options(const ReadFlags& flags);

}  // namespace percuss::tools
