#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "acquire/live/journal_reader.hpp"
#include "acquire/live/wav_header.hpp"
#include "pipeline/live/guide.hpp"
#include "targets.hpp"

namespace percuss::fuzz {
namespace {

// Writes the right checksum into every block, so that the content of blocks is read and not only their checksums.
std::string with_checksums(std::string bytes) {
  constexpr std::size_t kCrcOffset = 24;
  const auto put_crc = [&](std::size_t at, std::uint32_t crc) {
    std::memcpy(bytes.data() + at + kCrcOffset, &crc, sizeof crc);
  };
  std::size_t at = acquire::kJournalHeader_bytes;
  while (at + acquire::kBlockHeader_bytes <= bytes.size()) {
    const auto header = acquire::parse_block_header(std::string_view(bytes).substr(at, acquire::kBlockHeader_bytes));
    if (!header || header->payload_bytes > bytes.size() - at - acquire::kBlockHeader_bytes) break;
    const std::size_t length = acquire::kBlockHeader_bytes + header->payload_bytes;
    put_crc(at, 0);
    const auto* block = reinterpret_cast<const unsigned char*>(bytes.data() + at);
    put_crc(at, static_cast<std::uint32_t>(crc32_z(0, block, length)));
    at += length;
  }
  return bytes;
}

struct NoLog : acquire::SessionLog {
  void append_event(const std::string& /*json*/) override {}
};

struct NoObserver : pipeline::GuideObserver {
  void on_blow(const pipeline::BlowReport& /*blow*/) override {}
};

// Goes on with the session, as percuss record --resume does.
void resume(const std::string& path) {
  const acquire::JournalReader journal(path);
  std::vector<pipeline::SessionEvent> events;
  for (const acquire::JournalEvent& event : journal.events())
    events.push_back(pipeline::parse_session_event(event.json, path));
  NoObserver observer;
  NoLog log;
  pipeline::Guide guide(journal.format(), pipeline::live_channels(journal.format(), {}),
                        {.folder = std::filesystem::temp_directory_path()}, log, observer);
  guide.resume_from(events, journal.findings());
  constexpr std::size_t kPiece_frames = 1000;
  for (const acquire::FrameRange& range : journal.ranges()) {
    for (std::uint64_t at = 0; at < range.frames; at += kPiece_frames) {
      const auto frames = static_cast<std::size_t>(std::min<std::uint64_t>(kPiece_frames, range.frames - at));
      guide.take({.first_frame = range.first + at, .frames = frames, .values = journal.read(range.first + at, frames)});
    }
  }
  guide.finish();
}

}  // namespace

void run_wav_header(std::string_view bytes) {
  accepted([&] {
    acquire::read_wav_header([&](std::span<std::byte> out) {
      if (out.size() > bytes.size()) return false;
      std::transform(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(out.size()), out.begin(),
                     [](char c) { return static_cast<std::byte>(c); });
      bytes.remove_prefix(out.size());
      return true;
    });
  });
}

void run_journal(std::string_view bytes) {
  const MemfdFile as_stored(bytes);
  accepted([&] { resume(as_stored.path()); });
  const MemfdFile valid(with_checksums(std::string(bytes)));
  accepted([&] { resume(valid.path()); });
}

}  // namespace percuss::fuzz
