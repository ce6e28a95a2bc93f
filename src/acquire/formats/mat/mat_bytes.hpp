#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace percuss::acquire {

/// `word` in the byte order of this machine, from a file whose byte order is the other one if `swapped`.
inline std::uint32_t native_word(std::uint32_t word, bool swapped) { return swapped ? __builtin_bswap32(word) : word; }

/// The bytes of a MAT file of level 4 or 5, read at any place. `path` must outlive the object.
class MatBytes {
 public:
  explicit MatBytes(const std::string& path);
  ~MatBytes();
  MatBytes(const MatBytes&) = delete;
  MatBytes& operator=(const MatBytes&) = delete;

  const std::string& path() const { return path_; }
  std::uint64_t size() const { return size_; }

  /// Reads `bytes` bytes from position `at`. errors  InputError: the file ends before, or cannot be read.
  void read(std::uint64_t at, void* out, std::size_t bytes) const;
  /// Numbers of 32 bits from position `at`. errors  as read
  template <std::size_t kCount>
  std::array<std::uint32_t, kCount> words(std::uint64_t at, bool swapped) const {
    std::array<std::uint32_t, kCount> out{};
    read(at, out.data(), sizeof out);
    for (std::uint32_t& word : out) word = native_word(word, swapped);
    return out;
  }

 private:
  const std::string& path_;
  int descriptor_;
  std::uint64_t size_;
};

/// Level 4: each variable begins with five numbers: type, rows, columns, 1 for complex, length of the name in bytes.
namespace level4 {

inline constexpr std::size_t kTag_words = 5;
/// Whether the variable has the other byte order: its type or the length of its name would be 2^24 or more.
inline bool is_swapped(const std::array<std::uint32_t, kTag_words>& tag) {
  return tag[0] >= 0x1000000U || tag[4] >= 0x1000000U;
}

}  // namespace level4

/// Level 5: a header, then variables, each after a tag of two numbers: its type and its size in bytes.
namespace level5 {

inline constexpr std::uint64_t kHeader_bytes = 128;
inline constexpr std::size_t kTag_words = 2;
inline constexpr std::uint64_t kTag_bytes = kTag_words * sizeof(std::uint32_t);
inline constexpr std::uint32_t kMatrix = 14, kCompressed = 15;  // types of variables

/// Whether the file has the other byte order. errors  as MatBytes::read
bool is_swapped(const MatBytes& file);

}  // namespace level5
}  // namespace percuss::acquire
