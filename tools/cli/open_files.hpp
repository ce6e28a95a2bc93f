#pragma once
#include <variant>
#include <vector>

#include "cli/read_flags.hpp"

namespace percuss::tools {

/// One path opened with finished options.
acquire::Record open_record_at(const ReadFlags& flags, const acquire::ReadOptions& options, std::size_t index);

/// What the files hold: records of time or FRFs, never both.
struct Measurements {
  std::vector<acquire::Record> records;
  std::vector<frf::FrfRecord> frfs;
};

/// Every path opened as what it is. InputError for records of time beside FRFs; UsageError as open_records.
Measurements open_measurements(const ReadFlags& flags);

/// One path opened as what it is, with finished options.
std::variant<acquire::Record, frf::FrfRecord> open_measurement_at(const ReadFlags& flags,
                                                                  const acquire::ReadOptions& options,
                                                                  std::size_t index);

/// Files of FRFs as one test: several are points. UsageError when --files says hits.
frf::FrfRecord join_frfs_of(const ReadFlags& flags, std::vector<frf::FrfRecord> frfs);

/// Every path opened; UsageError for none, or for one that is named twice; what several of them mean is the caller's
/// affair (join_records).
std::vector<acquire::Record> open_records(const ReadFlags& flags);

}  // namespace percuss::tools
