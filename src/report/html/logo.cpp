#include "report/html/logo.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

#include "core/error.hpp"
#include "core/io/csv_dialect.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/input_file.hpp"
#include "report/text/digest.hpp"

namespace percuss::report {
namespace {

constexpr std::string_view kPngSignature{"\x89PNG\r\n\x1a\n", 8};
constexpr std::string_view kPngEnd{"IEND\xae\x42\x60\x82", 8};
constexpr std::uint32_t kMaxPixels = 4096;  // of each side

[[noreturn]] void refuse(const std::string& problem, const std::string& where) {
  throw InputError(problem, where, "give a small PNG, JPEG or plain SVG picture", {"logo"});
}

std::uint32_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8U | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

void require_size(std::uint32_t width, std::uint32_t height, const std::string& where) {
  if (width == 0 || height == 0 || width > kMaxPixels || height > kMaxPixels)
    refuse(fmt::format("a picture of {} × {} pixels; each side must have 1 to {}", width, height, kMaxPixels), where);
}

void check_png(std::string_view bytes, const std::string& where) {
  constexpr std::size_t kWidthAt = 16, kHeightAt = 20, kShortest = 45;
  if (bytes.size() < kShortest || bytes.substr(12, 4) != "IHDR" || !bytes.ends_with(kPngEnd))
    refuse("a PNG picture that is cut short or has data after its end", where);
  require_size(big_endian(bytes, kWidthAt, 4), big_endian(bytes, kHeightAt, 4), where);
}

// Walks the segments of a JPEG up to the frame header, which holds the size.
void check_jpeg(std::string_view bytes, const std::string& where) {
  constexpr std::uint8_t kScan = 0xDA;
  if (!bytes.ends_with("\xFF\xD9")) refuse("a JPEG picture that is cut short or has data after its end", where);
  for (std::size_t at = 2; at + 9 < bytes.size() && bytes[at] == '\xFF';) {
    const auto marker = static_cast<std::uint8_t>(bytes[at + 1]);
    const bool frame = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
    if (frame) return require_size(big_endian(bytes, at + 7, 2), big_endian(bytes, at + 5, 2), where);
    if (marker == kScan) break;
    at += 2 + big_endian(bytes, at + 2, 2);
  }
  refuse("a JPEG picture without a size", where);
}

// Whether an attribute such as onload= stands in the text: "on" after a character other than a letter or "-", then
// letters, blanks, "=".
bool has_event_handler(std::string_view lower) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t at = lower.find("on"); at != std::string_view::npos; at = lower.find("on", at + 1)) {
    if (at == 0 || letter(lower[at - 1]) || lower[at - 1] == '-') continue;
    std::size_t end = at;
    while (end < lower.size() && letter(lower[end])) ++end;
    while (end < lower.size() && blank(lower[end])) ++end;
    if (end > at + 2 && end < lower.size() && lower[end] == '=') return true;
  }
  return false;
}

// Whether every occurrence of `word` is followed by a "#", a reference within the picture. Blanks, quotes, "=" and "("
// may stand between them.
bool only_local(std::string_view lower, std::string_view word) {
  for (std::size_t at = lower.find(word); at != std::string_view::npos; at = lower.find(word, at + 1)) {
    const std::size_t next = lower.find_first_not_of(" \t\r\n=\"'(", at + word.size());
    if (next == std::string_view::npos || lower[next] != '#') return false;
  }
  return true;
}

void check_svg(std::string_view bytes, const std::string& where) {
  constexpr std::array<std::string_view, 9> kForbidden{"<script",   "<foreignobject", "<iframe",
                                                       "<!doctype", "<!entity",       "<?xml-stylesheet",
                                                       "@import",   "javascript:",    "<handler"};
  const std::string lower = lower_case(std::string(bytes));
  for (const std::string_view word : kForbidden) {
    if (lower.find(word) != std::string::npos) refuse(fmt::format("an SVG picture with {}", word), where);
  }
  if (has_event_handler(lower)) refuse("an SVG picture with an event handler", where);
  if (!only_local(lower, "href") || !only_local(lower, "url(") || !only_local(lower, "src"))
    refuse("an SVG picture that refers to something outside it", where);
  if (lower.find("</svg") == std::string::npos && lower.find("/>") == std::string::npos)
    refuse("an SVG picture that is cut short", where);
}

// The text after a byte-order mark, blanks, an XML declaration and comments.
std::string_view first_element(std::string_view text) {
  text = without_byte_order_mark(text);
  while (true) {
    const std::size_t at = text.find_first_not_of(" \t\r\n");
    if (at == std::string_view::npos) return {};
    text.remove_prefix(at);
    const std::string_view close = text.starts_with("<?") ? "?>" : text.starts_with("<!--") ? "-->" : "";
    if (close.empty()) return text;
    const std::size_t end = text.find(close);
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + close.size());
  }
}

const char* media_type(std::string_view bytes, const std::string& where) {
  if (bytes.starts_with(kPngSignature)) {
    check_png(bytes, where);
    return "image/png";
  }
  if (bytes.starts_with("\xFF\xD8\xFF")) {
    check_jpeg(bytes, where);
    return "image/jpeg";
  }
  if (first_element(bytes).starts_with("<svg")) {
    check_svg(bytes, where);
    return "image/svg+xml";
  }
  refuse("not a picture that a page can hold", where);
}

}  // namespace

std::string logo_data_uri(std::string_view bytes, const std::string& where) {
  if (bytes.size() > kMaxLogo_bytes) refuse(fmt::format("{} bytes, more than {}", bytes.size(), kMaxLogo_bytes), where);
  const std::string type = media_type(bytes, where);
  return "data:" + type + ";base64," + base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

std::string logo_of_file(const std::string& path) {
  constexpr std::uint64_t kMaxRead_bytes = std::uint64_t{64} << 20U;  // logo_data_uri says what is too large
  return logo_data_uri(read_input(path, kMaxRead_bytes).view(), path);
}

}  // namespace percuss::report
