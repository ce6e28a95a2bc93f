#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "acquire/live/sample_stream.hpp"

// The bytes of a journal (docs/reference/journal.md): a file header, then blocks. Numbers are little-endian.
//   file header   8 bytes "PERCUSSJ", uint32 version, uint32 0
//   block         uint32 type, uint32 payload bytes, uint64 first frame, uint32 frames, uint32 flags, uint32 CRC-32,
//                 uint32 0; then the payload. The CRC covers the header with a CRC of 0, and the payload.
namespace percuss::acquire {

inline constexpr std::uint32_t kJournalVersion = 1;
inline constexpr std::size_t kJournalHeader_bytes = 16, kBlockHeader_bytes = 32;
inline constexpr std::uint32_t kMaxBlockPayload_bytes = std::uint32_t{1} << 24U;

/// "form": the stream's format as JSON, once at the start of a session and of each resumption. "samp": interleaved
/// samples. "evnt": JSON of an event of the recording session. "find": JSON of a finding.
enum class JournalBlockType : std::uint32_t {
  format = 0x6d726f66,
  samples = 0x706d6173,
  event = 0x746e7665,
  finding = 0x646e6966
};

/// Bits of JournalBlockHeader::flags: samples were lost before the block (SampleBlock::overrun); floats of 8 bytes.
inline constexpr std::uint32_t kBlockOverrun = 1, kBlockFloat64 = 2;

struct JournalBlockHeader {
  JournalBlockType type = JournalBlockType::samples;
  std::uint32_t payload_bytes = 0;
  std::uint64_t first_frame = 0;
  std::uint32_t frames = 0;
  std::uint32_t flags = 0;
  std::uint32_t crc = 0;
};

std::string journal_header();
/// Nothing where the bytes are no journal; otherwise its version.
std::optional<std::uint32_t> journal_version(std::string_view head);

/// A whole block with its checksum.
std::string journal_block(JournalBlockType type, std::string_view payload, std::uint64_t frame = 0);
/// A block of samples, as floats of 4 bytes where this loses nothing, else of 8 bytes. `out` is overwritten, so that
/// its memory is used again.
void make_sample_block(const SampleBlock& block, std::size_t channels, std::string& out);

/// Nothing where these 32 bytes cannot be a block's header.
std::optional<JournalBlockHeader> parse_block_header(std::string_view bytes);
/// Whether the checksum of a block fits.
bool block_is_whole(std::string_view header, std::string_view payload);
/// The values of a block of samples.
std::vector<double> block_values(const JournalBlockHeader& header, std::string_view payload);

std::string format_json(const StreamFormat& format);
/// errors  InputError at `where`
StreamFormat parse_format(const std::string& json, const std::string& where);

}  // namespace percuss::acquire
