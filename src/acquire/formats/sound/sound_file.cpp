#include "acquire/formats/sound/sound_file.hpp"

#include <sndfile.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "acquire/formats/sound/sound_length.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {
namespace {

constexpr std::string_view kW64 = "riff\x2E\x91\xCF\x11";
constexpr std::size_t kMaxChunk_bytes = std::size_t{16} << 20U;
constexpr std::size_t kFramesAtOnce = 16384;

// Bytes of a stored sample; 0 for compressed formats.
std::size_t sample_bytes(int format) {
  switch (format & SF_FORMAT_SUBMASK) {
    case SF_FORMAT_PCM_U8:  // these containers hold no signed bytes
      return 1;
    case SF_FORMAT_PCM_16:
      return 2;
    case SF_FORMAT_PCM_24:
      return 3;
    case SF_FORMAT_PCM_32:
    case SF_FORMAT_FLOAT:
      return 4;
    case SF_FORMAT_DOUBLE:
      return 8;
    default:
      return 0;
  }
}

using SoundHandle = std::unique_ptr<SNDFILE, int (*)(SNDFILE*)>;

SF_CHUNK_INFO chunk_named(std::string_view id) {
  SF_CHUNK_INFO info{};
  std::copy_n(id.begin(), std::min(id.size(), sizeof info.id), info.id);
  info.id_size = static_cast<unsigned>(id.size());
  return info;
}

}  // namespace

bool is_sound(std::string_view head) {
  const auto begins = [&](std::string_view start) { return head.substr(0, start.size()) == start; };
  const bool wave = head.size() >= 12 && head.substr(8, 4) == "WAVE";
  return begins(kW64) || ((begins("RIFF") || begins("RIFX") || begins("RF64")) && wave);
}

struct SoundInput::Impl {
  std::string path;
  SF_INFO info{};
  SoundHandle file{nullptr, sf_close};
  mutable std::mutex mutex;  // the library has one position in the file

  [[noreturn]] void fail(const std::string& problem) const { throw InputError(problem, path, "export the file again"); }
};

SoundInput::SoundInput(const std::string& path) : impl_(std::make_unique<Impl>()) {
  Impl& impl = *impl_;
  impl.path = path;
  // The library accepts other formats on weak evidence, so the signature is checked first.
  if (!is_sound(first_bytes(path, 64))) impl.fail("not a WAV, RF64 or W64 file");
  impl.file.reset(sf_open(path.c_str(), SFM_READ, &impl.info));
  if (impl.file == nullptr) impl.fail(std::string("damaged: ") + sf_strerror(nullptr));
  const std::size_t bytes = sample_bytes(impl.info.format);
  std::string problem;
  if (bytes == 0) {
    problem = "compressed samples, neither PCM nor floating point";
  } else if (static_cast<std::uintmax_t>(impl.info.frames) >
             std::filesystem::file_size(path) / bytes / static_cast<std::uintmax_t>(impl.info.channels)) {
    // sf_open has refused files without channels, rates below 1 Hz and negative numbers of frames.
    problem = "more samples than the file has bytes for";
  }
  if (!problem.empty()) impl.fail(problem);
}

SoundInput::~SoundInput() = default;

std::size_t SoundInput::channels() const { return static_cast<std::size_t>(impl_->info.channels); }
std::size_t SoundInput::frames() const { return static_cast<std::size_t>(impl_->info.frames); }
int SoundInput::rate_Hz() const { return impl_->info.samplerate; }

std::optional<std::uint64_t> SoundInput::frames_of_whole_file() const {
  const auto bytes = stated_sample_bytes(impl_->path);
  if (!bytes) return std::nullopt;
  const std::uint64_t frames = *bytes / (sample_bytes(impl_->info.format) * channels());
  return frames > this->frames() ? std::optional(frames) : std::nullopt;
}

std::string SoundInput::format() const {
  const int type = impl_->info.format & SF_FORMAT_TYPEMASK;
  return type == SF_FORMAT_W64 ? "W64" : type == SF_FORMAT_RF64 ? "RF64" : "WAV";
}

std::optional<std::string> SoundInput::chunk(std::string_view id) const {
  const std::scoped_lock lock(impl_->mutex);
  SF_CHUNK_INFO info = chunk_named(id);
  SF_CHUNK_ITERATOR* const at = sf_get_chunk_iterator(impl_->file.get(), &info);
  if (at == nullptr || sf_get_chunk_size(at, &info) != SF_ERR_NO_ERROR) return std::nullopt;
  if (info.datalen > kMaxChunk_bytes || info.datalen > std::filesystem::file_size(impl_->path))
    impl_->fail("a custom chunk that is too long");
  std::string text(info.datalen, '\0');
  info.data = text.data();
  if (sf_get_chunk_data(at, &info) != SF_ERR_NO_ERROR) return std::nullopt;
  return text;
}

void SoundInput::read(std::size_t channel, std::size_t first, std::span<double> out) const {
  const std::size_t channels = this->channels();
  std::vector<double> frames(std::min(out.size(), kFramesAtOnce) * channels);
  const std::scoped_lock lock(impl_->mutex);
  if (sf_seek(impl_->file.get(), static_cast<sf_count_t>(first), SEEK_SET) < 0) impl_->fail("truncated");
  for (std::size_t done = 0; done < out.size();) {
    const std::size_t count = std::min(out.size() - done, kFramesAtOnce);
    if (sf_readf_double(impl_->file.get(), frames.data(), static_cast<sf_count_t>(count)) !=
        static_cast<sf_count_t>(count))
      impl_->fail("truncated");
    for (std::size_t n = 0; n < count; ++n) out[done + n] = frames[n * channels + channel];
    done += count;
  }
}

struct SoundOutput::Impl {
  Impl(const std::string& its_path, bool force) : path(its_path), target(its_path, force) {}
  std::string path;
  AtomicFile target;
  std::string chunk;  // the library reads it when it closes the file
  SoundHandle file{nullptr, sf_close};
  std::size_t channels = 1;

  [[noreturn]] void fail() const {
    throw InputError(std::string("cannot write: ") + sf_strerror(file.get()), path, "is there room on the disk?");
  }
};

SoundOutput::SoundOutput(const std::string& path, bool force, SoundKind kind, std::size_t channels, int rate_Hz,
                         const std::vector<std::uint32_t>& cues, const std::optional<Chunk>& chunk)
    : impl_(std::make_unique<Impl>(path, force)) {
  Impl& impl = *impl_;
  impl.channels = channels;
  const int type = kind == SoundKind::wav ? SF_FORMAT_WAV : kind == SoundKind::rf64 ? SF_FORMAT_RF64 : SF_FORMAT_W64;
  SF_INFO info{};
  info.samplerate = rate_Hz;
  info.channels = static_cast<int>(channels);
  info.format = type | SF_FORMAT_DOUBLE;
  if (sf_format_check(&info) == 0) {
    throw InputError(std::to_string(channels) + " channels, or the sampling rate, exceed the limits of the format",
                     path, "write it as HDF5");
  }
  impl.file.reset(sf_open(impl.target.temporary_path().c_str(), SFM_WRITE, &info));
  if (impl.file == nullptr) impl.fail();
  // The chunk PEAK contains the time of day; see clear_time_stamp().
  sf_command(impl.file.get(), SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);
  if (kind == SoundKind::w64) return;
  if (!cues.empty()) {
    // As SF_CUES, for any number of cues: a count, then the cues.
    std::vector<std::uint32_t> block(1 + cues.size() * sizeof(SF_CUE_POINT) / sizeof(std::uint32_t));
    block[0] = static_cast<std::uint32_t>(cues.size());
    for (std::size_t c = 0; c < cues.size(); ++c) {
      SF_CUE_POINT point{};
      point.indx = static_cast<std::int32_t>(c + 1);
      point.position = cues[c];
      point.sample_offset = cues[c];
      std::memcpy(&point.fcc_chunk, "data", 4);
      std::memcpy(block.data() + 1 + c * sizeof point / sizeof(std::uint32_t), &point, sizeof point);
    }
    sf_command(impl.file.get(), SFC_SET_CUE, block.data(), static_cast<int>(block.size() * sizeof(std::uint32_t)));
  }
  if (!chunk) return;
  impl.chunk = chunk->text;
  impl.chunk.resize((impl.chunk.size() + 3) / 4 * 4, ' ');
  SF_CHUNK_INFO chunk_info = chunk_named(chunk->id);
  chunk_info.data = impl.chunk.data();
  chunk_info.datalen = static_cast<unsigned>(impl.chunk.size());
  if (sf_set_chunk(impl.file.get(), &chunk_info) != SF_ERR_NO_ERROR) impl.fail();
}

SoundOutput::~SoundOutput() = default;

void SoundOutput::append(std::span<const double> values) {
  const auto frames = static_cast<sf_count_t>(values.size() / impl_->channels);
  if (sf_writef_double(impl_->file.get(), values.data(), frames) != frames) impl_->fail();
}

namespace {

// The library writes the time of day into the chunk PEAK and cannot omit this chunk in RF64.
void clear_time_stamp(const std::string& path) {
  constexpr std::size_t kFirstChunk = 12, kChunkHead = 8, kTime = 4, kSearched_bytes = std::size_t{1} << 16U;
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  std::string head(kSearched_bytes, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  file.clear();
  for (std::size_t at = kFirstChunk; at + kChunkHead + kTime + 4 <= head.size();) {
    const std::string id = head.substr(at, 4);
    std::uint32_t bytes = 0;
    std::memcpy(&bytes, &head[at + 4], sizeof bytes);
    if (id == "data") return;
    if (id == "PEAK") {
      file.seekp(static_cast<std::streamoff>(at + kChunkHead + kTime));
      file.write("\0\0\0\0", 4);
      return;
    }
    at += kChunkHead + bytes + bytes % 2;
  }
}

}  // namespace

void SoundOutput::commit() {
  const int closed = sf_close(impl_->file.release());  // writes the lengths
  if (closed != 0) impl_->fail();
  clear_time_stamp(impl_->target.temporary_path());
  impl_->target.commit();
}

}  // namespace percuss::acquire
