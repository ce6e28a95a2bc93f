#pragma once
#include <cstddef>
#include <string>

namespace percuss::accuracy {

/// A Markdown page whose paragraphs and list items have lines of at most `width` characters. Tables, headings, images,
/// HTML and blocks of code stay unchanged.
std::string wrap_prose(const std::string& page, std::size_t width);

}  // namespace percuss::accuracy
