#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace percuss::acquire {

/// The number of bytes of samples that the header of a WAV, RF64 or W64 file states. Nothing if it states none:
/// programs that write to a pipe do not know the length and write 0 or about 2 or 4 GiB. Nothing for damaged headers
/// either.
std::optional<std::uint64_t> stated_sample_bytes(const std::string& path);

}  // namespace percuss::acquire
