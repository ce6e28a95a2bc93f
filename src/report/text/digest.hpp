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

/// The SHA-256 of what comes a piece at a time.
class Digest {
 public:
  Digest();
  ~Digest();
  Digest(const Digest&) = delete;
  Digest& operator=(const Digest&) = delete;
  void add(std::string_view bytes);
  Sha256 result();  // once, last

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Of a file's bytes, a piece at a time; nothing when it cannot be read.
std::string sha256_of_file(const std::string& path);

std::string hexadecimal(std::span<const std::uint8_t> bytes);
/// RFC 4648, with padding.
std::string base64(std::span<const std::uint8_t> bytes);
/// The same back. Throws std::out_of_range for another text.
std::string from_base64(std::string_view text);

}  // namespace percuss::report
