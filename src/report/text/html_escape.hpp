#pragma once
#include <string>
#include <string_view>

namespace percuss::report {

/// A text as it may stand in HTML, between tags and in quoted attributes: what would be read as markup escaped, control
/// characters as blanks, bytes that are no UTF-8 replaced.
std::string html_escape(std::string_view text);

}  // namespace percuss::report
