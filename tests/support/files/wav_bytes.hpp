#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace percuss::test {

/// The lowest `bytes` bytes of a number: little-endian, or big-endian for RIFX.
inline std::string bytes_of_number(std::uint64_t value, std::size_t bytes, bool big = false) {
  std::string out;
  for (std::size_t i = 0; i < bytes; ++i) out += static_cast<char>(value >> 8U * (big ? bytes - 1 - i : i) & 0xFFU);
  return out;
}

/// The header of a WAV file, and the chunks around its samples.
struct Wav {
  std::uint64_t kind = 1, channels = 2, rate_Hz = 1000, bits = 16;  // kind 1: integers, 3: floating point
  bool big = false;
  std::string before = {}, after = {};              // chunks before and after the samples
  std::optional<std::uint64_t> claimed_bytes = {};  // of samples, in the header; empty: the true number
};

/// The bytes of a WAV file with the header `w` and these samples.
inline std::string wav_bytes(const Wav& w, const std::string& samples) {
  const auto n = [&](std::uint64_t value, std::size_t bytes) { return bytes_of_number(value, bytes, w.big); };
  const std::uint64_t frame = w.channels * w.bits / 8;
  const std::string format =
      n(w.kind, 2) + n(w.channels, 2) + n(w.rate_Hz, 4) + n(w.rate_Hz * frame, 4) + n(frame, 2) + n(w.bits, 2);
  const std::string body = "WAVEfmt " + n(format.size(), 4) + format + w.before + "data" +
                           n(w.claimed_bytes.value_or(samples.size()), 4) + samples + w.after;
  return (w.big ? "RIFX" : "RIFF") + n(body.size(), 4) + body;
}

}  // namespace percuss::test
