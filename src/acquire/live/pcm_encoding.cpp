#include "acquire/live/pcm_encoding.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "core/error.hpp"

namespace percuss::acquire {
namespace {

static_assert(std::endian::native == std::endian::little, "samples of pipes are little-endian");

struct EncodingTraits {
  std::string_view name;
  PcmEncoding encoding;
  std::size_t bytes;
  SampleType type;
};

constexpr std::array kEncodings = {
    EncodingTraits{"s16", PcmEncoding::s16, 2, SampleType::int32},
    EncodingTraits{"s24", PcmEncoding::s24, 3, SampleType::int32},
    EncodingTraits{"s32", PcmEncoding::s32, 4, SampleType::int32},
    EncodingTraits{"f32", PcmEncoding::f32, 4, SampleType::float32},
    EncodingTraits{"f64", PcmEncoding::f64, 8, SampleType::float64},
};

const EncodingTraits& traits_of(PcmEncoding encoding) { return kEncodings[static_cast<std::size_t>(encoding)]; }

// The bytes become the highest ones of a 32-bit number.
void widen(std::size_t sample_bytes, std::span<const std::byte> bytes, std::vector<std::byte>& out) {
  const std::size_t samples = bytes.size() / sample_bytes, lowest = sizeof(std::int32_t) - sample_bytes;
  out.assign(samples * sizeof(std::int32_t), std::byte{0});
  for (std::size_t i = 0; i < samples; ++i)
    std::memcpy(out.data() + i * sizeof(std::int32_t) + lowest, bytes.data() + i * sample_bytes, sample_bytes);
}

}  // namespace

PcmEncoding pcm_encoding(std::string_view name) {
  for (const EncodingTraits& traits : kEncodings) {
    if (traits.name == name) return traits.encoding;
  }
  throw InputError("an unknown encoding of samples", one_line(name), "use s16, s24, s32, f32 or f64", {"device"});
}

std::size_t pcm_bytes(PcmEncoding encoding) { return traits_of(encoding).bytes; }

SampleType pcm_type(PcmEncoding encoding) { return traits_of(encoding).type; }

void decode_pcm(PcmEncoding encoding, std::span<const std::byte> bytes, std::vector<std::byte>& out) {
  if (pcm_type(encoding) == SampleType::int32) return widen(pcm_bytes(encoding), bytes, out);
  out.assign(bytes.begin(), bytes.end());
}

}  // namespace percuss::acquire
