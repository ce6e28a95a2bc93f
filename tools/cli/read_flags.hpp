#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "acquire/record/record.hpp"
#include "cli/command_line.hpp"
#include "cli/host.hpp"
#include "frf/frf_record.hpp"

namespace percuss::tools {

/// The options that say how recorded files are to be read; shared by analyze, frf, info and calibrate.
struct ReadFlags {
  std::vector<std::string> paths;
  acquire::ReadOptions options;
  std::string setup_path;                                          // --setup CHANNELS.json
  acquire::FileGrouping files = acquire::FileGrouping::automatic;  // --files
  std::optional<frf::FrfKind> frf_kind;                            // --frf-kind
  bool trust_input = false;                                        // --trust-input
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
void add_trust_input_option(Command& command, ReadFlags& flags);
inline constexpr const char* kReadingHeading = "Reading";

/// The set-up file and typed units worked into flags.options. Throws InputError.
acquire::ReadOptions resolved_read_options(const ReadFlags& flags);

/// The options for one of several files: of a scale per file, that file's. UsageError for another number of scales.
acquire::ReadOptions read_options_of_file(const acquire::ReadOptions& all, std::size_t index, std::size_t files);

/// Finished options of files of which each is opened by itself, whatever the flags name; UsageError for values per
/// file.
frf::FrfReadOptions per_file_read_options(const ReadFlags& flags);

}  // namespace percuss::tools
