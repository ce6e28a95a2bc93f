#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>

#include "acquire/formats/mat/mat_bytes.hpp"
#include "acquire/formats/mat/mat_file.hpp"

namespace percuss::acquire {
namespace {

// A file of level 4 starts with five numbers in either byte order: type, rows, columns, 0 or 1 for complex, length of
// the first variable's name. The decimal digits of the type are M (byte order, 0 or 1), O (0), P (precision, 0 to 5)
// and T (kind of matrix, 0 to 2).
bool is_mat4(std::string_view head) {
  std::array<std::uint32_t, level4::kTag_words> words{};
  if (head.size() < sizeof words) return false;
  std::memcpy(words.data(), head.data(), sizeof words);
  const bool swapped = level4::is_swapped(words);
  for (std::uint32_t& word : words) word = native_word(word, swapped);
  const auto [type, rows, columns, complex, name] = words;
  const bool known_type = (type < 100 || (type >= 1000 && type < 1100)) && type % 10 <= 2 && type % 100 / 10 <= 5;
  const std::size_t name_end = sizeof words + name - 1;
  return known_type && rows > 0 && columns > 0 && complex <= 1 && name >= 2 && name <= 64 && name_end < head.size() &&
         head[name_end] == '\0' && std::isalpha(static_cast<unsigned char>(head[sizeof words])) != 0;
}

}  // namespace

bool is_mat(std::string_view head) { return head.substr(0, 7) == "MATLAB " || is_mat4(head); }

}  // namespace percuss::acquire
