#pragma once
#include <string>

namespace percuss::tools {

/// Whether texts on this descriptor are coloured: it is a terminal, TERM is not "dumb", and NO_COLOR is unset or empty.
bool wants_color(int descriptor);

/// The text of a report with the colours of a terminal: warnings ("! …") in yellow, verdicts "ok" in green and
/// "rejected" in red. The text must hold no control characters other than line ends.
std::string in_color(const std::string& text);

inline constexpr const char *kRed = "\033[31m", *kYellow = "\033[33m", *kGreen = "\033[32m", *kPlain = "\033[0m";

}  // namespace percuss::tools
