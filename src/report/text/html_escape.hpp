#pragma once
#include <string>
#include <string_view>

namespace percuss::report {

/// Escapes a text for HTML, between tags and in quoted attributes: markup characters escaped, control characters as
/// blanks, bytes that are not UTF-8 replaced.
std::string html_escape(std::string_view text);

}  // namespace percuss::report
