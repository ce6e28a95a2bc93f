#pragma once
#include <string>

#include "report/html/title_block.hpp"

namespace percuss::report {

/// A self-contained page: style, scripts and data are part of the file. A content-security policy names the scripts and
/// styles by their SHA-256, so that nothing else can run, whatever the data contain.
struct HtmlPage {
  std::string title;  // plain text
  std::string body;   // HTML; its texts are escaped already
  TitleBlock block;   // for the paper, and whether the page shows a logo
  std::string data;   // JSON in ASCII for the scripts in src/report/html/page; empty: no scripts

  /// The document.
  std::string text() const;
};

/// The title of a page for the browser: the user's, or else the name of the file.
std::string page_title(const std::string& name, const TitleBlock& block);

}  // namespace percuss::report
