#include "acquire/live/wav_header.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr std::uint64_t kMaxBeforeSamples_bytes = std::uint64_t{16} << 20U;
constexpr std::uint32_t kUnknownSize = 0xffffffff;
constexpr std::uint16_t kPcmTag = 1, kFloatTag = 3, kExtensibleTag = 0xfffe;

[[noreturn]] void refuse(const char* problem) {
  throw InputError(problem, "standard input", "write uncompressed WAV, or state the samples: stdin:raw:s24:51200:2",
                   {"device"});
}

template <class Number>
Number number_in(std::span<const std::byte> bytes, std::size_t at) {
  Number number;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

class HeaderReader {
 public:
  explicit HeaderReader(const std::function<bool(std::span<std::byte>)>& fill) : fill_(fill) {}

  WavHeader read() {
    const auto riff = take(12);
    const std::string_view id = text(riff, 0);
    if ((id != "RIFF" && id != "RF64") || text(riff, 8) != "WAVE") refuse("standard input is not WAV");
    for (;;) {
      const auto chunk = take(8);
      const std::string_view name = text(chunk, 0);
      const auto size = number_in<std::uint32_t>(chunk, 4);
      if (name == "data") return with_data(size);
      // Chunks have even lengths.
      const auto content = take(std::uint64_t{size} + size % 2);
      if (name == "fmt ") take_format(content);
      if (name == kCalibrationChunk) take_calibration(content, size);
      if (name == "ds64" && content.size() >= 16) data_bytes_ = number_in<std::uint64_t>(content, 8);
    }
  }

 private:
  std::vector<std::byte> take(std::uint64_t size) {
    taken_ += size;
    if (taken_ > kMaxBeforeSamples_bytes) refuse("more than 16 MiB before the samples of the WAV stream");
    std::vector<std::byte> bytes(static_cast<std::size_t>(size));
    if (!fill_(bytes)) refuse("the WAV stream ends in its header, or none came");
    return bytes;
  }

  static std::string_view text(const std::vector<std::byte>& bytes, std::size_t at) {
    return {reinterpret_cast<const char*>(bytes.data()) + at, 4};  // NOLINT: names of chunks are text
  }

  void take_format(const std::vector<std::byte>& fmt) {
    if (fmt.size() < 16) refuse("the WAV stream has a damaged format");
    auto tag = number_in<std::uint16_t>(fmt, 0);
    if (tag == kExtensibleTag && fmt.size() >= 26) tag = number_in<std::uint16_t>(fmt, 24);
    const auto bits = number_in<std::uint16_t>(fmt, 14);
    WavHeader header;
    header.channels = number_in<std::uint16_t>(fmt, 2);
    header.fs_Hz = number_in<std::uint32_t>(fmt, 4);
    constexpr std::size_t kMaxWavChannels = 1024;
    if (header.channels == 0 || header.channels > kMaxWavChannels || !(header.fs_Hz > 0))
      refuse("the WAV stream has no channels, no rate, or too many channels");
    if (tag == kPcmTag && bits == 16) {
      header.encoding = PcmEncoding::s16;
    } else if (tag == kPcmTag && bits == 24) {
      header.encoding = PcmEncoding::s24;
    } else if (tag == kPcmTag && bits == 32) {
      header.encoding = PcmEncoding::s32;
    } else if (tag == kFloatTag && bits == 32) {
      header.encoding = PcmEncoding::f32;
    } else if (tag == kFloatTag && bits == 64) {
      header.encoding = PcmEncoding::f64;
    } else {
      refuse("the WAV stream is compressed, or its samples have an unusual size");
    }
    header_ = header;
  }

  void take_calibration(const std::vector<std::byte>& content, std::uint32_t size) {
    const std::string_view all(reinterpret_cast<const char*>(content.data()), size);  // NOLINT: the chunk is a text
    calibration_ =
        parse_calibration(all.substr(0, all.find('\0')), "standard input: " + std::string(kCalibrationChunk));
  }

  WavHeader with_data(std::uint32_t size) const {
    if (!header_) refuse("the WAV stream has samples before their format");
    WavHeader header = *header_;
    if (calibration_ && calibration_->signals.size() != header.channels)
      refuse("the WAV stream describes other channels than it has");
    header.calibration = calibration_;
    if (size == kUnknownSize && data_bytes_) header.data_bytes = *data_bytes_;
    // Recorders that write to a pipe state 0, the largest size or one just below it.
    constexpr std::uint32_t kLargestCredible = 0x7ffff000;
    if (size > 0 && size < kLargestCredible) header.data_bytes = size;
    if (header.data_bytes == 0) header.data_bytes = std::numeric_limits<std::uint64_t>::max();
    return header;
  }

  const std::function<bool(std::span<std::byte>)>& fill_;
  std::uint64_t taken_ = 0;
  std::optional<WavHeader> header_;
  std::optional<std::uint64_t> data_bytes_;
  std::optional<SoundCalibration> calibration_;
};

}  // namespace

WavHeader read_wav_header(const std::function<bool(std::span<std::byte>)>& fill) { return HeaderReader(fill).read(); }

}  // namespace percuss::acquire
