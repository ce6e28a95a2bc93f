#pragma once
#include <map>
#include <string>
#include <vector>

#include "batch/manifest.hpp"

namespace percuss::batch {

/// Messages name at most this many records.
inline constexpr std::size_t kMaxNamed = 10;

/// The progress of a batch, from the files in the folder of its results.
struct BatchStatus {
  std::size_t shards = 1;
  std::size_t records = 0, bytes = 0;
  std::vector<std::size_t> missing;         // shards with records and without a part-i.ok, ascending
  std::size_t finished = 0;                 // finished records, also in unfinished shards
  std::size_t failed = 0;                   // records, of finished shards
  std::size_t empty = 0;                    // shards without a record: they need no run
  std::map<std::string, std::string> open;  // reasons by id: records that a fault of the machine left open
  std::vector<std::string> stuck;  // ids of records begun at least twice and never finished: they may crash a worker
};

/// errors  InputError: a finished part in the folder has another plan, other options or another number of shards
BatchStatus batch_status(const Manifest& manifest, const std::string& folder);

/// The document percuss/batch-status/1, indented, with a line end.
std::string status_json(const BatchStatus& status);
/// The status as text.
std::string status_text(const BatchStatus& status);

/// Numbers as Slurm reads them: "0,3,4"; empty for none.
std::string array_list(const std::vector<std::size_t>& shards);

}  // namespace percuss::batch
