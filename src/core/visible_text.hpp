#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace percuss {
inline namespace core {

/// Whether visible_text() keeps the byte in every text: printable ASCII, line feeds and tabs.
constexpr bool is_plain(char byte) { return (byte >= ' ' && byte <= '~') || byte == '\n' || byte == '\t'; }

/// The number of bytes of the UTF-8 character at the start of `text`, which is not empty; 0 for bytes that are not
/// UTF-8, also for overlong forms and surrogates.
std::size_t utf8_length(std::string_view text);

/// Whether all of `text` is UTF-8 as utf8_length() accepts it.
bool is_utf8(std::string_view text);

/// Removes the first character of `text`, which is not empty, and returns it in visible form. A character that a
/// terminal obeys or does not show becomes its JSON escape, such as \u202e: control characters (C0, DEL, C1), line and
/// paragraph separators, marks of the direction of writing, characters without width. A byte that is not UTF-8 becomes
/// an escape such as \xff.
std::string take_visible(std::string_view& text);

/// `text` for a terminal: its characters as take_visible() shows them. Line feeds and tabs stay. A JSON document keeps
/// its meaning.
std::string visible_text(std::string_view text);

}  // namespace core
}  // namespace percuss
