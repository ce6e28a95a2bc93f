#pragma once
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "acquire/live/journal_writer.hpp"

namespace percuss::acquire {

/// The journal of a session when the disk may be full. Events and findings that cannot be written wait in memory, in
/// order, up to 16 MiB; later ones are dropped. Samples are offered again by the caller.
class SessionJournal {
 public:
  explicit SessionJournal(JournalWriter writer);
  ~SessionJournal();
  SessionJournal(const SessionJournal&) = delete;
  SessionJournal& operator=(const SessionJournal&) = delete;

  /// Appends an event or a finding now, or when the disk has room again.
  void append_text(std::string block);
  /// Appends samples. Nothing where the disk refuses them, or refused something less than 0.2 s ago.
  std::optional<std::uint64_t> append_samples(const std::string& block);
  /// Tries again to write the texts that wait. Whether none waits.
  bool flush();
  /// Waits until everything written is on the disk. Otherwise this happens once a second, in a thread of its own: a
  /// slow disk must not delay the blocks that follow.
  void sync();
  /// Waits until a write that the disk has refused may be tried again.
  void wait_for_retry() const;
  /// Why the disk refused the last write; empty while it accepts them.
  std::string fault() const;

  const JournalWriter& writer() const { return writer_; }

 private:
  using Clock = std::chrono::steady_clock;
  bool accept(int error);
  bool flush_locked();
  void sync_every_second();

  JournalWriter writer_;
  mutable std::mutex mutex_;
  std::deque<std::string> waiting_;
  std::size_t waiting_bytes_ = 0;
  std::string fault_;
  Clock::time_point retry_{};
  std::condition_variable wake_;
  bool closing_ = false;
  std::thread syncing_;
};

}  // namespace percuss::acquire
