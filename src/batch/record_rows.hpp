#pragma once
#include <memory>
#include <string>
#include <vector>

#include "batch/manifest.hpp"
#include "frf/frf_record.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::acquire {
class ForkServer;
}

namespace percuss::batch {

/// How every record of a batch is read and analysed.
struct RowOptions {
  frf::FrfReadOptions read;
  pipeline::AnalysisOptions analysis;
  bool frf = false;                                    // a row per run with its FRFs as well
  std::shared_ptr<acquire::ForkServer> fork_server{};  // forks the confined readers, where there is one
};

/// What a record came to, as lines of JSON without their ends: a "record", its "mode"s in ascending order, its "frf"s.
struct RecordRows {
  std::vector<std::string> lines;
  bool failed = false;  // the record's row says why
};

/// Reads and analyses one record. What percuss analyze would refuse is a row with the same words as its `reason` and
/// the same exit code as its `code`: nothing about the record is thrown. Text that is not UTF-8 is replaced.
RecordRows rows_of(const BatchRecord& record, const RowOptions& options);

}  // namespace percuss::batch
