#pragma once
#include <string>

#include "cli/output.hpp"

namespace percuss::tools {

/// Writes a page: HTML unchanged, PDF as a browser prints it.
/// errors  InputError: no browser, or it fails; as write_file
void write_page(const std::string& path, const std::string& html, const OutputFlags& flags);

/// Checks that a browser for PDF pages is installed.
/// errors  InputError at `path`: as find_browser
void require_browser(const std::string& path);

}  // namespace percuss::tools
