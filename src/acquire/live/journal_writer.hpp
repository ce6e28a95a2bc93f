#pragma once
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>

#include "acquire/live/capture_finding.hpp"
#include "acquire/live/journal_format.hpp"

namespace percuss::acquire {

/// The journal of a running session: a locked file that grows by whole blocks, one system call each. A block that is
/// written survives a kill of the process at any later moment. sync() also makes it survive a loss of power. Several
/// threads may call at the same time.
class JournalWriter {
 public:
  struct Outcome {
    int error = 0;             // a value of errno; 0: done
    std::uint64_t offset = 0;  // of the block in the file
  };

  /// Makes a new journal.
  /// errors  InputError: it exists and `overwrite` is off, or cannot be made; it is in use
  JournalWriter(std::string path, const StreamFormat& format, bool overwrite);
  /// Continues a journal after its last whole block: cuts off the rest, and appends the format and a finding.
  /// `seamless`: the next frame follows the last one.
  /// errors  InputError: as JournalReader; another process writes it; `format` differs in channels or rate
  static JournalWriter resumed(const std::string& path, const StreamFormat& format, bool seamless = false);
  JournalWriter(JournalWriter&& other) noexcept;
  JournalWriter(const JournalWriter&) = delete;
  JournalWriter& operator=(const JournalWriter&) = delete;
  ~JournalWriter();

  /// Appends a block as journal_block() and make_sample_block() make it. After a failure the file ends as before.
  Outcome append(const std::string& block);
  Outcome append(const CaptureFinding& finding);
  /// Waits until the blocks are on the disk. A value of errno; 0: done.
  int sync() const;

  /// The bytes of a block at an offset that append() returned; empty where they cannot be read.
  std::string block_at(std::uint64_t offset, std::size_t bytes) const;
  std::uint64_t size_bytes() const;
  const std::string& path() const { return path_; }
  /// The first frame number that a resumed session may use: one second after the last frame of the journal, so that
  /// nobody takes the sessions for continuous; directly after it if resumed with `seamless`. 0 for a journal without
  /// samples.
  std::uint64_t next_frame() const { return next_frame_; }

 private:
  JournalWriter(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}
  [[noreturn]] void fail(const char* problem, int error) const;
  void lock() const;

  std::string path_;
  int descriptor_ = -1;
  std::uint64_t end_ = 0, next_frame_ = 0;
  mutable std::mutex mutex_;
};

}  // namespace percuss::acquire
