#pragma once
#include <cstdint>

namespace percuss::acquire {

/// The largest plausible sample, in N, m/s² or Pa. Larger numbers mark gaps (instruments write 9.91e37) or come from
/// damaged files; their squares could overflow.
constexpr double kMaxSample = 1e30;

/// The bytes of decoded numbers that a file may claim to hold: 64 times its size plus 64 MiB. gzip rarely compresses
/// measured samples better than 4:1; a small file with a larger claim could fill the memory.
constexpr std::uint64_t claim_limit_bytes(std::uint64_t file_bytes) {
  constexpr std::uint64_t kPerFileByte = 64, kExtra_bytes = std::uint64_t{64} << 20U;
  constexpr std::uint64_t kMaxFile_bytes = std::uint64_t{1} << 50U;  // the product must not overflow
  return kPerFileByte * (file_bytes < kMaxFile_bytes ? file_bytes : kMaxFile_bytes) + kExtra_bytes;
}

}  // namespace percuss::acquire
