#pragma once
#include <string>
#include <vector>

#include "batch/manifest.hpp"
#include "core/io/csv_cell.hpp"

namespace percuss::batch {

struct MergeOptions {
  bool force = false;  // replace existing files
  CsvFormulas formulas = CsvFormulas::neutralise;
};

struct FailedRecord {
  std::string id, reason;
};

struct MergedBatch {
  std::size_t records = 0, failed = 0;
  std::vector<FailedRecord> first_failed;  // at most kMaxNamed (status.hpp)
};

/// Writes the rows of all shards, ordered by id, to each file, in constant memory. The extension gives the format:
///   .jsonl  a head, then a line of JSON per record and per mode (docs/schema/batch.schema.json)
///   .csv    the same rows as a table; lists are separated by blanks, absent values are empty cells
///   .h5, .hdf5  of a batch with FRFs: a group per record with the content of an FRF file
/// Equal plans give equal bytes for any number of shards. The files are whole or absent.
/// errors  InputError: a shard is missing or changed after it was finished; its plan or options differ from the
/// manifest's; the shards have different versions of percuss; a file exists (without force); HDF5 of a batch without
/// FRFs
MergedBatch merge_batch(const Manifest& manifest, const std::string& folder, const std::vector<std::string>& paths,
                        const MergeOptions& options = {});

}  // namespace percuss::batch
