#include "cli/page_output.hpp"

#include "cli/pdf/print_pdf.hpp"
#include "core/io/atomic_file.hpp"

namespace percuss::tools {

void write_page(const std::string& path, const std::string& html, const OutputFlags& flags) {
  write_file(path, extension_of(path) == ".pdf" ? printed_pdf(html, path) : html, flags.force);
}

void require_browser(const std::string& path) { find_browser(path); }

}  // namespace percuss::tools
