#pragma once
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "batch/manifest.hpp"
#include "batch/part.hpp"

namespace percuss::batch {

/// A shard's finished records while it runs: a file that lines are appended to, each with one call of the system, so
/// that a process that is killed at any moment leaves whole lines and at most one that is torn at the end, which the
/// next one cuts off. What was finished is kept; each thread loses the record it was at, and nothing else.
///   first line   the shard's label
///   begun 17     record 17 is being analysed
///   done 17 …    its rows, with a digest: a line that a crash of the whole system has damaged counts as absent
/// Several threads may call begin() and finish() at once. errors  InputError: another process is at this shard, the
/// file is of another plan or version (unless `anew`), the disk is full.
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
  /// The rows of a finished record, each with its line's end.
  std::string rows(std::size_t index) const;
  /// Removes the file, when the shard's rows stand where they belong.
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
  std::vector<Entry> entries_;  // of the rows in the file
  std::size_t finished_ = 0, failed_ = 0;
  std::uint64_t end_ = 0;
  std::mutex mutex_;
  int descriptor_ = -1;
};

/// How far the process came that left this journal: records finished, and those begun twice or more and never finished.
struct JournalState {
  std::size_t finished = 0;
  std::vector<std::size_t> stuck;  // indices, ascending
};
JournalState journal_state(const std::string& path);

}  // namespace percuss::batch
