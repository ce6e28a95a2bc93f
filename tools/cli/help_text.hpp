#pragma once
#include <cstddef>
#include <string>

#include "cli/declaration.hpp"

namespace percuss::tools {

/// What --help prints, at most `width` characters wide where its words allow it.
std::string help_text(const Declaration& all, const DeclaredCommand& command, std::size_t width);

}  // namespace percuss::tools
