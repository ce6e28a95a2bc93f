#pragma once
#include <string>
#include <string_view>

namespace percuss::report {

/// The largest picture, in bytes: every page embeds it.
inline constexpr std::size_t kMaxLogo_bytes = 200'000;

/// A PNG, JPEG or SVG picture as a data URI for an <img> element, in which a browser runs no scripts and loads nothing.
/// errors  InputError at `where`: another kind of file; cut short; more than kMaxLogo_bytes or 4096 pixels; an SVG with
/// scripts, event handlers, entities, or references outside itself.
std::string logo_data_uri(std::string_view bytes, const std::string& where);

/// The same for a file.
/// errors  InputError: also, it cannot be read
std::string logo_of_file(const std::string& path);

}  // namespace percuss::report
