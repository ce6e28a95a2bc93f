#pragma once
#include <functional>
#include <string>

#include "batch/manifest.hpp"
#include "batch/part.hpp"
#include "batch/record_rows.hpp"

namespace percuss::batch {

/// A shard to run. Paths of records are relative to the working folder, which is the folder of the manifest.
struct ShardJob {
  const Manifest* manifest = nullptr;
  std::size_t shard = 0, shards = 1;
  std::string folder;  // of the results; it exists
  RowOptions options;
  std::size_t threads = 0;        // each record uses one thread
  bool force = false;             // discard existing results
  std::function<void()> advance;  // any thread calls it after each record; may be empty
};

struct ShardOutcome {
  FinishedShard part;
  std::size_t analysed = 0;  // records in this run; earlier runs finished the others
};

/// Analyses the unfinished records of a shard, then writes part-i.jsonl and part-i.ok. Does nothing
/// for a shard with a valid part-i.ok. The rows depend neither on the number of threads nor on interruptions. errors
/// InputError: the folder cannot be written or holds results of another plan; another process analyses this shard. A
/// faulty record is a row, not an error.
ShardOutcome run_shard(const ShardJob& job);

}  // namespace percuss::batch
