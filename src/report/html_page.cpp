#include "report/html_page.hpp"

#include "report/digest.hpp"
#include "report/html_text.hpp"
#include "report/page_texts.hpp"

namespace percuss {
namespace {

std::string source_of(const std::string& text) { return "'sha256-" + base64(sha256(text)) + "'"; }

// JSON within a script element: no "<" may end it.
std::string data_text(const nlohmann::ordered_json& data) {
  std::string out;
  for (const char c : data.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace)) {
    if (c == '<' || c == '>' || c == '&') {
      out += c == '<' ? "\\u003c" : c == '>' ? "\\u003e" : "\\u0026";
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace

std::string HtmlPage::text() const {
  const std::string style = std::string(page_texts().plot_style) + std::string(page_texts().style);
  const std::string program = std::string(page_texts().plot_program) + std::string(page_texts().program);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; base-uri 'none'; form-action "
         "'none'; "
         "script-src " +
         source_of(program) + "; style-src " + source_of(style) +
         "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
         html_text(title) + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n" + body +
         "<script type=\"application/json\" id=\"data\">" + data_text(data) + "</script>\n<script>" + program +
         "</script>\n</body>\n</html>\n";
}

}  // namespace percuss
