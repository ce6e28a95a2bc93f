#pragma once
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "batch/manifest.hpp"
#include "batch/part.hpp"

namespace percuss::batch {

/// The finished records of a running shard: a file with one system call per appended line. A killed process leaves
/// whole lines and at most one incomplete last line, which the next process cuts off. Finished records are kept; each
/// thread loses at most the record that it was analysing.
///   first line   the label of the shard
///   begun 17     record 17 is being analysed
///   done 17 …    its rows, with a digest: a line damaged by a system crash counts as absent
/// Several threads may call begin() and finish() at the same time.
/// errors  InputError: another process analyses this shard; the file is from another plan or version (unless `anew`);
/// the disk is full
class Journal {
 public:
  Journal(std::string path, const ShardLabel& label, ShardRange range, bool anew);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  bool has(std::size_t index) const { return entries_[index - range_.first].bytes > 0; }
  std::size_t finished() const { return finished_; }
  std::size_t failed() const { return failed_; }
  void begin(std::size_t index);
  void finish(std::size_t index, bool failed, const std::vector<std::string>& lines);
  /// The rows of a finished record, each with its line end.
  std::string rows(std::size_t index) const;
  /// Removes the file after the rows of the shard have been written.
  void remove();

 private:
  struct Entry {
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;  // 0: not finished
  };
  void lock() const;
  void load(const ShardLabel& label, bool anew);
  void take(std::string_view line, std::uint64_t offset);
  void append(const std::string& line);

  std::string path_;
  ShardRange range_;
  std::vector<Entry> entries_;  // the rows of each record in the file
  std::size_t finished_ = 0, failed_ = 0;
  std::uint64_t end_ = 0;
  std::mutex mutex_;
  int descriptor_ = -1;
};

/// The progress in a journal: the finished records, and the records begun at least twice and never finished.
struct JournalState {
  std::size_t finished = 0;
  std::vector<std::size_t> stuck;  // indices, ascending
};
JournalState journal_state(const std::string& path);

}  // namespace percuss::batch
