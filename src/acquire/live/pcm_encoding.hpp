#pragma once
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "acquire/live/device.hpp"

namespace percuss::acquire {

/// Samples as recorders write them, little-endian.
enum class PcmEncoding { s16, s24, s32, f32, f64 };

/// The encoding named "s16", "s24", "s32", "f32" or "f64".
/// errors  InputError: another name
PcmEncoding pcm_encoding(std::string_view name);

std::size_t pcm_bytes(PcmEncoding encoding);
/// The type of the numbers that decode_pcm() makes. Whole numbers become 32-bit ones, full scale at 2^31.
SampleType pcm_type(PcmEncoding encoding);

/// Decodes samples of `encoding` into numbers of pcm_type(); `bytes` holds whole samples. `out` is overwritten.
void decode_pcm(PcmEncoding encoding, std::span<const std::byte> bytes, std::vector<std::byte>& out);

}  // namespace percuss::acquire
