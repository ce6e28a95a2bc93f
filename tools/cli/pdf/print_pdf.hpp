#pragma once
#include <string>

namespace percuss::tools {

/// The browser that prints pages: the program that the environment variable PERCUSS_BROWSER names, else Chromium,
/// Chrome or Edge, if one is installed.
/// errors  InputError at `where`: none is installed, or PERCUSS_BROWSER names no program
std::string find_browser(const std::string& where);

/// A page as a PDF document, printed by a headless browser that has no network and an empty profile.
/// errors  InputError at `where`: no browser; the browser fails, or takes more than a minute
///         InputError at the temporary file: the page cannot be written
std::string printed_pdf(const std::string& html, const std::string& where);

}  // namespace percuss::tools
