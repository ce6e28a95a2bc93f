#pragma once
#include <string>

namespace percuss::report {

/// A page that is one file: its style, its programs and its data within it, nothing from anywhere else. A
/// content-security policy names the programs and styles by their SHA-256: nothing else on the page can run, whatever
/// the data hold.
struct HtmlPage {
  std::string title;  // plain text
  std::string body;   // HTML; texts in it have gone through html_escape
  std::string data;   // JSON in ASCII: what src/report/page draws; none: no program on the page

  /// The whole document.
  std::string text() const;
};

}  // namespace percuss::report
