#pragma once
#include <cstddef>
#include <string>

#include "cli/declaration.hpp"

namespace percuss::tools {

/// The output of --help, wrapped to `width` characters except for example lines.
std::string help_text(const Declaration& all, const DeclaredCommand& command, std::size_t width);

}  // namespace percuss::tools
