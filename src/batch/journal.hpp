#pragma once
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "batch/manifest.hpp"
#include "batch/part.hpp"
#include "batch/part_file.hpp"

namespace percuss::batch {

/// The finished records of a running shard, in a file. One system call appends each line, so that a killed process
/// leaves whole lines and at most one incomplete last line, which the next process cuts off. Finished records are kept;
/// each thread loses at most the record that it was analysing.
///   first line   the label of the shard
///   begun 17     record 17 is being analysed
///   done 17 …    its rows, with a digest: a line damaged by a system crash counts as absent
///   open 17 …    a fault of the machine: the next run analyses record 17 again
///   again 17     the rows of record 17 no longer count: its file, which was lost, is back
/// Several threads may call begin(), finish() and leave_open() at the same time.
/// errors  InputError: another process analyses this shard; the file is from another plan or version (unless `anew`),
/// or not a journal; MachineFault: the disk is full or failed
class Journal {
 public:
  Journal(std::string path, const ShardLabel& label, ShardRange range, bool anew);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  bool has(std::size_t index) const { return entries_[index - range_.first].bytes > 0; }
  std::size_t finished() const { return finished_; }
  std::size_t failed() const { return failed_; }
  /// Whether a finished record failed.
  bool failed(std::size_t index) const { return entries_[index - range_.first].failed; }
  void begin(std::size_t index);
  void finish(std::size_t index, bool failed, const std::vector<std::string>& lines);
  /// Notes why a record is not finished, if the disk allows it.
  void leave_open(std::size_t index, const std::string& reason);
  /// Discards the rows of a finished record.
  void reopen(std::size_t index);
  /// The rows of a finished record, each with its line end.
  std::string rows(std::size_t index) const;
  /// Removes the file after the rows of the shard have been written.
  void remove();

 private:
  struct Entry {
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;  // 0: not finished
    bool failed = false;
  };
  void load(const ShardLabel& label, bool anew);
  void take(std::string_view line, std::uint64_t offset);
  void discard(std::size_t index);
  void append(const std::string& line);
  void remove_incomplete_line();

  std::string path_;
  PartFile file_;
  ShardRange range_;
  std::vector<Entry> entries_;  // the rows of each record in the file
  std::size_t finished_ = 0, failed_ = 0;
  std::uint64_t end_ = 0;
  std::mutex mutex_;
  bool incomplete_ = false;  // the file ends with a line that could not be written whole
};

inline constexpr std::size_t kMaxReason_bytes = 1000;  // of a record left open

/// Removes the journal of a finished shard if a process was killed before it could do so. A journal that another
/// process has locked stays. errors  InputError: the file is not a journal
void remove_abandoned_journal(const std::string& path);

/// The progress in a journal: the finished records; the records begun at least twice and never finished; the records
/// that a fault of the machine left open.
struct JournalState {
  std::size_t finished = 0;
  std::vector<std::size_t> stuck;           // indices, ascending
  std::map<std::size_t, std::string> open;  // reasons by index
};
JournalState journal_state(const std::string& path);

}  // namespace percuss::batch
