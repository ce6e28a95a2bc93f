#pragma once
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"

namespace percuss {

/// What a page says of how it came about; nothing else on it depends on when and where.
struct Provenance {
  std::string command;  // the command line
  std::string made_at;  // UTC, "2026-11-22 21:45"
};

// Pieces of a page's body, as HTML. Texts are plain, and escaped here.

/// A section under a heading; `content` is HTML.
std::string page_section(const char* id, const char* heading, const std::string& content);
std::string page_paragraph(const std::string& text);
/// A place for page/page.js to draw in, and what it shows in words for those who do not see it.
std::string page_picture(const char* kind, const std::string& description);
/// The file's name and what was measured how.
std::string page_header(const Analysis& analysis, std::size_t hits);
std::string page_warnings(const std::vector<Warning>& warnings);
std::string page_provenance(const Analysis& analysis, const Provenance& provenance);

}  // namespace percuss
