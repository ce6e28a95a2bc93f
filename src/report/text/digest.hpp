#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace percuss::report {

using Sha256 = std::array<std::uint8_t, 32>;

Sha256 sha256(std::string_view bytes);

/// The SHA-256 of bytes that are added piece by piece.
class Digest {
 public:
  Digest();
  ~Digest();
  Digest(const Digest&) = delete;
  Digest& operator=(const Digest&) = delete;
  void add(std::string_view bytes);
  Sha256 result();  // call it once, last

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The SHA-256 of a file, in hexadecimal; empty when the file cannot be read.
std::string sha256_of_file(const std::string& path);

std::string hexadecimal(std::span<const std::uint8_t> bytes);
/// RFC 4648, with padding.
std::string base64(std::span<const std::uint8_t> bytes);
/// Inverse of base64. errors  std::out_of_range: not base64.
std::string from_base64(std::string_view text);

}  // namespace percuss::report
