#include "acquire/formats/sound/sound_length.hpp"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <string_view>

namespace percuss::acquire {
namespace {

constexpr std::uint32_t kUnknown32 = 0x7FFF'0000;  // from this length on, the length is unknown: written to a pipe
constexpr std::size_t kMaxChunks = 4096;           // before the samples
constexpr std::uint64_t kMaxOffset = std::uint64_t{1} << 62U;
// A chunk of RIFF begins with four letters and four bytes of length. A chunk of W64 begins with a GUID of sixteen bytes
// and eight bytes of length; this length includes the 24 bytes.
constexpr std::size_t kRiffHead = 8, kRiffStart = 12, kW64Head = 24, kW64Start = 40;

std::uint64_t number_of(std::string_view bytes, bool big_endian) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::size_t at = big_endian ? i : bytes.size() - 1 - i;
    value = value << 8U | static_cast<unsigned char>(bytes[at]);
  }
  return value;
}

// `count` bytes from `offset` on; fewer if the file ends before.
std::string bytes_at(std::ifstream& file, std::uint64_t offset, std::size_t count) {
  std::string out(count, '\0');
  file.clear();
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(out.data(), static_cast<std::streamsize>(count));
  out.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return out;
}

std::optional<std::uint64_t> known(std::uint64_t bytes) {
  return bytes == 0 || bytes > kMaxOffset ? std::nullopt : std::optional(bytes);
}

std::optional<std::uint64_t> riff_sample_bytes(std::ifstream& file, bool big_endian) {
  std::optional<std::uint64_t> of_rf64;
  std::uint64_t at = kRiffStart;
  for (std::size_t chunk = 0; chunk < kMaxChunks; ++chunk) {
    const std::string head = bytes_at(file, at, kRiffHead);
    if (head.size() < kRiffHead) return std::nullopt;
    const std::uint64_t length = number_of(std::string_view(head).substr(4), big_endian);
    if (head.starts_with("data")) return of_rf64 ? of_rf64 : length >= kUnknown32 ? std::nullopt : known(length);
    if (head.starts_with("ds64")) {
      const std::string sizes = bytes_at(file, at + kRiffHead, 16);  // of the whole file, of the samples
      if (sizes.size() == 16) of_rf64 = known(number_of(std::string_view(sizes).substr(8), big_endian));
    }
    at += kRiffHead + length + length % 2;
  }
  return std::nullopt;
}

std::optional<std::uint64_t> w64_sample_bytes(std::ifstream& file) {
  std::uint64_t at = kW64Start;
  for (std::size_t chunk = 0; chunk < kMaxChunks && at < kMaxOffset; ++chunk) {
    const std::string head = bytes_at(file, at, kW64Head);
    if (head.size() < kW64Head) return std::nullopt;
    const std::uint64_t length = number_of(std::string_view(head).substr(16), false);
    if (length < kW64Head || length > kMaxOffset) return std::nullopt;
    if (head.starts_with("data")) return known(length - kW64Head);
    at += (length + 7) / 8 * 8;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::uint64_t> stated_sample_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string start = bytes_at(file, 0, 4);
  if (start == "riff") return w64_sample_bytes(file);
  return riff_sample_bytes(file, start == "RIFX");
}

}  // namespace percuss::acquire
