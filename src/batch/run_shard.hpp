#pragma once
#include <functional>
#include <string>

#include "batch/manifest.hpp"
#include "batch/part.hpp"
#include "batch/record_rows.hpp"

namespace percuss::batch {

/// One shard of a batch to be run. The records' paths are taken from the working folder, which is the manifest's.
struct ShardJob {
  const Manifest* manifest = nullptr;
  std::size_t shard = 0, shards = 1;
  std::string folder;  // of the results; it is there
  RowOptions options;
  std::size_t threads = 0;        // over the records; each record is one thread's
  bool force = false;             // start anew whatever is there
  std::function<void()> advance;  // called after every record, by any thread; may be empty
};

struct ShardOutcome {
  FinishedShard part;
  std::size_t analysed = 0;  // of its records; the others were finished before
};

/// Analyses the records of a shard that no earlier run has finished, and puts part-i.jsonl and part-i.ok in their
/// places. Nothing is done where a part-i.ok tells that it was done before. The rows do not depend on the number of
/// threads, nor on how often the work was broken off.
/// errors  InputError: the folder cannot be written, holds results of another plan, or another process is at this
/// shard. What is wrong with a record is its row, not an error.
ShardOutcome run_shard(const ShardJob& job);

}  // namespace percuss::batch
