#pragma once
#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "batch/manifest.hpp"
#include "batch/part.hpp"
#include "batch/record_rows.hpp"

namespace percuss::batch {

/// A shard to run. Paths of records are absolute, or relative to the working folder, which is the folder of the
/// manifest.
struct ShardJob {
  const Manifest* manifest = nullptr;
  std::size_t shard = 0, shards = 1;
  std::string folder;  // of the results; it exists
  RowOptions options;
  std::size_t threads = 0;  // 0: all; each record uses one thread
  bool force = false;       // discard existing results
  /// Waits before a record is tried again after a fault of the machine.
  std::vector<std::chrono::milliseconds> waits{std::chrono::milliseconds(100), std::chrono::milliseconds(500),
                                               std::chrono::seconds(2)};
  std::function<void()> advance;  // called on any thread after each finished record; may be empty
};

/// A record that failed, or that a fault of the machine left open.
struct RecordProblem {
  std::size_t index = 0;
  std::string reason;
};

struct ShardOutcome {
  FinishedShard part;                 // without `bytes` and `sha256` if records are open
  std::size_t analysed = 0;           // records in this run; earlier runs finished the others
  std::vector<RecordProblem> failed;  // failed records of this run, ascending; `analysed` counts them too
  /// Records without a result, ascending: the machine failed (no process, no memory, no descriptor, a full disk, …),
  /// not the record. The shard is not finished if there are any.
  std::vector<RecordProblem> open;
};

/// Analyses the unfinished records of a shard, then writes part-i.jsonl and part-i.ok. Also analyses records that
/// failed because their file was missing or not as planned, if the file is as planned now. Does nothing else for a
/// shard with a valid part-i.ok, and writes nothing for a shard without records. The rows depend neither on the number
/// of threads nor on interruptions. A faulty record is a row, not an error. A record that a fault of the machine stops
/// is tried again, then left open for the next run.
/// errors  InputError: the folder cannot be written or holds results of another plan; something else has the name of a
///         part; another process analyses this shard. MachineFault: the files of the shard cannot be written
ShardOutcome run_shard(const ShardJob& job);

}  // namespace percuss::batch
