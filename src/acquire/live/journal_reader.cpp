#include "acquire/live/journal_reader.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "core/io/read_at.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kMaxText_bytes = std::size_t{64} << 20U;
constexpr std::size_t kMaxRanges = 1000000;
constexpr std::size_t kBlocksPerPlace = 32;
constexpr std::uint64_t kMaxFrame = std::uint64_t{1} << 62U;

}  // namespace

JournalReader::JournalReader(std::string path) : path_(std::move(path)) {
  std::uint64_t size = 0;
  descriptor_ = open_regular_file(path_, std::numeric_limits<std::int64_t>::max(), size);
  try {
    const auto version = journal_version(bytes_at(0, kJournalHeader_bytes));
    if (!version)
      throw InputError("not a journal of a recording", path_, "name the journal or the output of a session");
    if (*version != kJournalVersion)
      throw InputError("the journal has another version", path_, "use the version of percuss that wrote it");
    scan();
    if (!has_format_) damaged("the journal ends before its first block");
    torn_bytes_ = std::max(size, whole_bytes_) - whole_bytes_;
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

JournalReader::~JournalReader() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void JournalReader::damaged(const char* problem) const {
  throw InputError(problem, path_, "the file cannot be resumed; record anew");
}

// Fewer bytes where the file ends before.
std::string JournalReader::bytes_at(std::uint64_t offset, std::size_t bytes) const {
  std::string out(bytes, '\0');
  const ReadResult got = read_at(descriptor_, offset, out.data(), bytes);
  if (got.error != 0) throw_system_error("cannot read the journal", got.error, path_, "check the disk");
  out.resize(got.bytes);
  return out;
}

void JournalReader::scan() {
  std::uint64_t offset = kJournalHeader_bytes;
  for (;;) {
    whole_bytes_ = offset;
    const std::string head = bytes_at(offset, kBlockHeader_bytes);
    const auto header = parse_block_header(head);
    if (!header) return;
    std::string payload = bytes_at(offset + kBlockHeader_bytes, header->payload_bytes);
    if (payload.size() != header->payload_bytes || !block_is_whole(head, payload)) return;
    const std::uint64_t next = offset + kBlockHeader_bytes + payload.size();
    take(*header, std::move(payload), offset);
    offset = next;
  }
}

void JournalReader::take(const JournalBlockHeader& header, std::string payload, std::uint64_t offset) {
  if (header.type == JournalBlockType::samples) return take_samples(header, payload.size(), offset);
  text_bytes_ += payload.size() + sizeof(JournalEvent);
  if (text_bytes_ > kMaxText_bytes) damaged("the journal holds more than 64 MiB of events");
  if (header.type == JournalBlockType::event) {
    events_.push_back({std::move(payload), end_frame()});
    return;
  }
  if (header.type == JournalBlockType::finding) findings_.push_back(parse_finding(payload, path_));
  if (header.type != JournalBlockType::format) return;  // blocks of unknown types are skipped
  StreamFormat format = parse_format(payload, path_);
  if (has_format_ && (format.channels != format_.channels || format.fs_Hz != format_.fs_Hz))
    damaged("the journal changes its channels or its rate");
  if (!has_format_) format_ = std::move(format);
  has_format_ = true;
}

void JournalReader::take_samples(const JournalBlockHeader& header, std::size_t payload_bytes, std::uint64_t offset) {
  const std::size_t number_bytes = (header.flags & kBlockFloat64) != 0 ? sizeof(double) : sizeof(float);
  if (!has_format_) damaged("the journal has samples before their description");
  if (header.frames == 0 || std::uint64_t{header.frames} * format_.channels * number_bytes != payload_bytes)
    damaged("a block of samples has another length than stated");
  if (header.first_frame < end_frame() || header.first_frame > kMaxFrame)
    damaged("the frames of the journal go back in time");
  const bool joins = !ranges_.empty() && header.first_frame == end_frame() && (header.flags & kBlockOverrun) == 0;
  if (!joins && ranges_.size() == kMaxRanges) damaged("the journal has more than a million gaps");
  if (!joins || ++blocks_since_place_ == kBlocksPerPlace) {
    places_.push_back({header.first_frame, offset});
    blocks_since_place_ = 0;
  }
  if (!joins) ranges_.push_back({header.first_frame, 0});
  ranges_.back().frames += header.frames;
}

std::uint64_t JournalReader::frames() const {
  std::uint64_t sum = 0;
  for (const FrameRange& range : ranges_) sum += range.frames;
  return sum;
}

bool JournalReader::has(std::uint64_t first, std::uint64_t count) const {
  const auto after = std::upper_bound(ranges_.begin(), ranges_.end(), first,
                                      [](std::uint64_t frame, const FrameRange& range) { return frame < range.first; });
  if (after == ranges_.begin()) return false;
  const FrameRange& range = *std::prev(after);
  const std::uint64_t skipped = first - range.first;
  return skipped <= range.frames && count <= range.frames - skipped;
}

std::vector<double> JournalReader::read(std::uint64_t first, std::size_t count) const {
  std::vector<double> out;
  if (count == 0) return out;
  if (!has(first, count)) throw InputError("frames are missing", path_, "they were lost while recording; use others");
  out.reserve(count * format_.channels);
  const auto after =
      std::upper_bound(places_.begin(), places_.end(), first,
                       [](std::uint64_t frame, const Place& place) { return frame < place.first_frame; });
  std::uint64_t offset = std::prev(after)->offset;
  while (out.size() < count * format_.channels) {
    const std::string head = bytes_at(offset, kBlockHeader_bytes);
    const auto header = parse_block_header(head);
    if (!header) damaged("the journal was changed");
    offset += kBlockHeader_bytes + header->payload_bytes;
    if (header->type != JournalBlockType::samples || header->first_frame + header->frames <= first) continue;
    const std::string payload = bytes_at(offset - header->payload_bytes, header->payload_bytes);
    if (payload.size() != header->payload_bytes || !block_is_whole(head, payload)) damaged("the journal was changed");
    const std::vector<double> values = block_values(*header, payload);
    const std::size_t from = header->first_frame < first ? static_cast<std::size_t>(first - header->first_frame) : 0;
    const std::size_t wanted = count - out.size() / format_.channels;
    const std::size_t part = std::min<std::size_t>(header->frames - from, wanted);
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(from * format_.channels);
    out.insert(out.end(), begin, begin + static_cast<std::ptrdiff_t>(part * format_.channels));
  }
  return out;
}

}  // namespace percuss::acquire
