#pragma once
#include <string>
#include <vector>

#include "batch/manifest.hpp"

namespace percuss::batch {

/// How far a batch has come, told from the files in the folder of its results and from nothing else.
struct BatchStatus {
  std::size_t shards = 1;
  std::size_t records = 0, bytes = 0;
  std::vector<std::size_t> missing;  // shards without a part-i.ok, ascending
  std::size_t finished = 0;          // records, those of shards that are not finished included
  std::size_t failed = 0;            // records, of finished shards
  std::vector<std::string> stuck;    // ids of records begun twice or more and never finished: they may end a worker
};

/// errors  InputError: a part in the folder is of another plan, options, division or version.
BatchStatus batch_status(const Manifest& manifest, const std::string& folder);

/// The document percuss/batch-status/1, indented, with a line's end.
std::string status_json(const BatchStatus& status);
/// The same for people.
std::string status_text(const BatchStatus& status);

/// Numbers as Slurm takes them: "0,3,4"; empty for none.
std::string array_list(const std::vector<std::size_t>& shards);

}  // namespace percuss::batch
