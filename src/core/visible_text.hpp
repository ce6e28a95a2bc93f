#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace percuss {
inline namespace core {

/// Whether visible_text() keeps the byte in every text: printable ASCII, line feeds and tabs.
constexpr bool is_plain(char byte) { return (byte >= ' ' && byte <= '~') || byte == '\n' || byte == '\t'; }

/// The bytes of the UTF-8 character at the start of `text`, which is not empty; 0 for bytes that are not UTF-8, also
/// for overlong forms and surrogates.
std::size_t utf8_length(std::string_view text);

/// Whether `text` consists of characters as utf8_length() counts them.
bool is_utf8(std::string_view text);

/// Removes the first character of `text`, which is not empty, and returns it as a reader is to see it. A character that
/// a terminal obeys or does not show becomes its escape in JSON, \u202e: control characters (C0, DEL, C1), line and
/// paragraph separators, marks of the direction of writing, characters without width. A byte that is not UTF-8 becomes
/// \xff.
std::string take_visible(std::string_view& text);

/// `text` for a terminal: its characters as take_visible() shows them. Line feeds and tabs stay. A JSON document keeps
/// its meaning.
std::string visible_text(std::string_view text);

}  // namespace core
}  // namespace percuss
