#pragma once
#include <string>
#include <vector>

#include "batch/manifest.hpp"

namespace percuss::batch {

struct MergedBatch {
  std::size_t records = 0, failed = 0;
};

/// Writes the rows of all shards, ordered by id, to each of the files by its extension; memory does not grow with them.
///   .jsonl  a head, then a line of JSON per record and per mode (docs/schema/batch.schema.json)
///   .csv    the same rows as a table; lists with blanks between; nothing in a cell where there is nothing
///   .h5     of a batch with FRFs: a group per record, in it what percuss frf -o FILE.h5 writes
/// Equal plans give equal bytes, into however many shards the work was divided. The files are whole or absent.
/// errors  InputError: shards that are missing, changed since they were finished, or made with other options or another
/// version of percuss than others; a file exists (without force); .h5 of a batch without FRFs.
MergedBatch merge_batch(const Manifest& manifest, const std::string& folder, const std::vector<std::string>& paths,
                        bool force);

}  // namespace percuss::batch
