#include "core/visible_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace percuss {
inline namespace core {
namespace {

struct CodeRange {
  std::uint32_t first, last;
};

// Unicode's control characters, separators of lines and paragraphs, Default_Ignorable_Code_Point, marks of annotations
// (U+FFF9 to U+FFFB), and four noncharacters (U+FFFE, U+FFFF, U+10FFFE, U+10FFFF); ascending.
constexpr std::array<CodeRange, 21> kHidden{{
    {0x0000, 0x001F},     {0x007F, 0x009F}, {0x00AD, 0x00AD},   {0x034F, 0x034F},   {0x061C, 0x061C},
    {0x115F, 0x1160},     {0x17B4, 0x17B5}, {0x180B, 0x180F},   {0x200B, 0x200F},   {0x2028, 0x202E},
    {0x2060, 0x206F},     {0x3164, 0x3164}, {0xFE00, 0xFE0F},   {0xFEFF, 0xFEFF},   {0xFFA0, 0xFFA0},
    {0xFFF0, 0xFFFB},     {0xFFFE, 0xFFFF}, {0x1BCA0, 0x1BCA3}, {0x1D173, 0x1D17A}, {0xE0000, 0xE0FFF},
    {0x10FFFE, 0x10FFFF},
}};

bool is_hidden(std::uint32_t code) {
  return std::any_of(kHidden.begin(), kHidden.end(),
                     [&](const CodeRange& range) { return range.first <= code && code <= range.last; });
}

std::uint32_t code_of(std::string_view character) {
  const auto first = static_cast<unsigned char>(character.front());
  constexpr std::array<std::uint32_t, 5> kFirstBits{0, 0x7F, 0x1F, 0x0F, 0x07};  // by the length of the character
  std::uint32_t code = first & kFirstBits.at(character.size());
  for (const char c : character.substr(1)) code = code << 6U | (static_cast<unsigned char>(c) & 0x3FU);
  return code;
}

// JSON writes characters beyond 16 bits as two surrogates.
std::string escaped(std::uint32_t code) {
  if (code < 0x10000) return fmt::format("\\u{:04x}", code);
  const std::uint32_t beyond = code - 0x10000;
  return fmt::format("\\u{:04x}\\u{:04x}", 0xD800U + (beyond >> 10U), 0xDC00U + (beyond & 0x3FFU));
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return follows(1) ? 2 : 0;
  if (first >= 0xE0 && first < 0xF0) {
    const bool forbidden = (first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0);
    return follows(1) && follows(2) && !forbidden ? 3 : 0;
  }
  if (first >= 0xF0 && first < 0xF5) {
    const bool forbidden = (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90);
    return follows(1) && follows(2) && follows(3) && !forbidden ? 4 : 0;
  }
  return 0;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string take_visible(std::string_view& text) {
  const std::size_t length = utf8_length(text);
  const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
  text.remove_prefix(character.size());
  if (length == 0) return fmt::format("\\x{:02x}", static_cast<unsigned char>(character.front()));
  const std::uint32_t code = code_of(character);
  return is_hidden(code) ? escaped(code) : std::string(character);
}

std::string visible_text(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const auto end = std::find_if_not(text.begin(), text.end(), is_plain);
    const auto kept = static_cast<std::size_t>(end - text.begin());
    out += text.substr(0, kept);
    text.remove_prefix(kept);
    if (!text.empty()) out += take_visible(text);
  }
  return out;
}

}  // namespace core
}  // namespace percuss
