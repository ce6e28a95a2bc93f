#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "acquire/live/capture_finding.hpp"
#include "acquire/live/journal_format.hpp"
#include "acquire/live/sample_stream.hpp"

namespace percuss::acquire {

/// Frames first … first + frames − 1 without a loss between them.
struct FrameRange {
  std::uint64_t first = 0, frames = 0;
  bool operator==(const FrameRange&) const = default;
};

/// An event of the recording session, and its place among the frames of the journal.
struct JournalEvent {
  std::string json;
  std::uint64_t frame = 0;  // the frame number after the last frame before the event in the file
};

/// The content of a journal up to the first damaged block. The bytes from there on are not used: an interrupted write
/// leaves them. Samples stay in the file: 16 bytes of memory for 32 blocks of them.
class JournalReader {
 public:
  /// errors  InputError: not readable, not a journal, of another version; its blocks contradict each other; more than
  /// 64 MiB of events, or a million gaps
  explicit JournalReader(std::string path);
  JournalReader(const JournalReader&) = delete;
  JournalReader& operator=(const JournalReader&) = delete;
  ~JournalReader();

  const std::string& path() const { return path_; }
  const StreamFormat& format() const { return format_; }
  const std::vector<JournalEvent>& events() const { return events_; }
  const std::vector<CaptureFinding>& findings() const { return findings_; }
  /// The frames in the journal, ascending. An overrun separates ranges even where no frame number is missing.
  const std::vector<FrameRange>& ranges() const { return ranges_; }
  /// The frame number after the last frame.
  std::uint64_t end_frame() const { return ranges_.empty() ? 0 : ranges_.back().first + ranges_.back().frames; }
  std::uint64_t frames() const;
  /// The bytes up to the end of the last whole block, and the bytes after it.
  std::uint64_t whole_bytes() const { return whole_bytes_; }
  std::uint64_t torn_bytes() const { return torn_bytes_; }

  /// Whether frames first … first + count − 1 are in one range.
  bool has(std::uint64_t first, std::uint64_t count) const;
  /// Their values, interleaved.
  /// errors  InputError: some are missing; the file has changed
  std::vector<double> read(std::uint64_t first, std::size_t count) const;

 private:
  struct Place {
    std::uint64_t first_frame = 0, offset = 0;
  };
  void scan();
  void take(const JournalBlockHeader& header, std::string payload, std::uint64_t offset);
  void take_samples(const JournalBlockHeader& header, std::size_t payload_bytes, std::uint64_t offset);
  std::string bytes_at(std::uint64_t offset, std::size_t bytes) const;
  [[noreturn]] void damaged(const char* problem) const;

  std::string path_;
  int descriptor_ = -1;
  StreamFormat format_;
  std::vector<JournalEvent> events_;
  std::vector<CaptureFinding> findings_;
  std::vector<FrameRange> ranges_;
  std::vector<Place> places_;  // of some blocks of samples, ascending
  std::size_t text_bytes_ = 0, blocks_since_place_ = 0;
  std::uint64_t whole_bytes_ = 0, torn_bytes_ = 0;
  bool has_format_ = false;
};

}  // namespace percuss::acquire
