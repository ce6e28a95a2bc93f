#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "acquire/record/frf_record.hpp"
#include "batch/manifest.hpp"
#include "core/error.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::acquire {
class ForkServer;
}

namespace percuss::batch {

/// The options for reading and analysing every record of a batch.
struct RowOptions {
  acquire::FrfReadOptions read;
  pipeline::AnalysisOptions analysis;
  bool frf = false;                                    // also a row per run with its FRFs
  std::shared_ptr<acquire::ForkServer> fork_server{};  // forks the sandboxed readers, if set
  OptionWriter write_option = nullptr;                 // notation of options in reasons; nullptr: without options
};

/// The result of a record as lines of JSON without line ends: a "record", its "mode"s in ascending order, its "frf"s.
struct RecordRows {
  std::vector<std::string> lines;
  bool failed = false;
  std::string reason;  // of a failed record
};

/// Reads and analyses one record. Without a force, which RowOptions::read must allow, the modes come from the free
/// decays, and there are no FRFs. A record that cannot be analysed gives a row with the message of the command
/// `analyze` as `reason` and its exit code as `code`. No error of a record is thrown. Text that is not UTF-8 is
/// replaced.
/// errors  MachineFault: the machine failed, so there is no result
RecordRows rows_of(const BatchRecord& record, const RowOptions& options);

/// Whether the record failed because its file was missing or not as planned, and the file is as planned now: the record
/// can be analysed. `record_row` is the first line of rows_of().
bool file_came_back(const BatchRecord& record, std::string_view record_row);

}  // namespace percuss::batch
