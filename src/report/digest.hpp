#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace percuss {

using Sha256 = std::array<std::uint8_t, 32>;

Sha256 sha256(std::string_view bytes);
/// Of a file's bytes, a piece at a time; nothing when it cannot be read.
std::string sha256_of_file(const std::string& path);

std::string hexadecimal(std::span<const std::uint8_t> bytes);
/// RFC 4648, with padding.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace percuss
