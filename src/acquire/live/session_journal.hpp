#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>

#include "acquire/live/journal_writer.hpp"

namespace percuss::acquire {

/// The journal of a session when the disk may be full. Events and findings that cannot be written wait in memory, in
/// order; samples are offered again by the caller.
class SessionJournal {
 public:
  explicit SessionJournal(JournalWriter writer) : writer_(std::move(writer)) {}

  /// Appends an event or a finding now, or when there is room again.
  void append_text(std::string block);
  /// Appends samples. Nothing where the disk refuses them, or refused something less than 0.2 s ago.
  std::optional<std::uint64_t> append_samples(const std::string& block);
  /// Tries again to write the texts that wait. Whether none waits.
  bool flush();
  /// Synchronises once a second at most; `now` always.
  void sync(bool now);
  /// Why the disk refused the last write; empty while it accepts them.
  std::string fault() const;

  const JournalWriter& writer() const { return writer_; }

 private:
  using Clock = std::chrono::steady_clock;
  bool accept(int error);
  bool flush_locked();

  JournalWriter writer_;
  mutable std::mutex mutex_;
  std::deque<std::string> waiting_;
  std::size_t waiting_bytes_ = 0;
  std::string fault_;
  Clock::time_point retry_{}, synced_ = Clock::now();
};

}  // namespace percuss::acquire
