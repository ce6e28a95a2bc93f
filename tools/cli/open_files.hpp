#pragma once
#include <string>
#include <variant>
#include <vector>

#include "cli/read_flags.hpp"

namespace percuss::tools {

/// The files that the arguments name: folders and patterns (* ? [ ]) are replaced by the records in them, "hit2" before
/// "hit10". Throws InputError for a folder without records and a pattern without a match.
struct FoundFiles {
  std::vector<std::string> paths;
  std::vector<std::string> left_out;  // files of the folders whose extension no format has
};
FoundFiles found_files(const std::vector<std::string>& paths);

/// The paths, with patterns (* ? [ ]) replaced by the files that match, "hit2" before "hit10". Throws InputError for a
/// pattern without a match.
std::vector<std::string> matched_files(const std::vector<std::string>& paths);

/// The flags with found_files() as paths, so that a reading option with a value per file counts the files that were
/// found. Files that a shell put in the order of characters ("p1 p10 p2") follow in natural order, as do their force
/// scales; open_records() and open_measurements() note it. The inputs of a host are not changed.
ReadFlags with_found_files(const ReadFlags& given);

/// Opens the path (or the host's input) of this index as a record. `options` come from resolved_read_options().
acquire::Record open_record_at(const ReadFlags& flags, const acquire::ReadOptions& options, std::size_t index);

/// Contents of the files: records or FRFs, never both.
struct Measurements {
  std::vector<acquire::Record> records;
  std::vector<acquire::FrfRecord> frfs;
};

/// Opens every path as a record or as FRFs. Throws InputError for a mixture of both; UsageError as open_records.
Measurements open_measurements(const ReadFlags& flags);

/// Opens the path (or the host's input) of this index as a record or as FRFs, with `options` as above.
std::variant<acquire::Record, acquire::FrfRecord> open_measurement_at(const ReadFlags& flags,
                                                                      const acquire::ReadOptions& options,
                                                                      std::size_t index);

/// Joins files of FRFs to one test; several files are points. Throws UsageError for --files hits.
acquire::FrfRecord join_frfs_of(const ReadFlags& flags, std::vector<acquire::FrfRecord> frfs);

/// Opens every path as a record. Throws UsageError for no path or a path given twice. The caller groups several records
/// with join_records.
std::vector<acquire::Record> open_records(const ReadFlags& flags);

}  // namespace percuss::tools
