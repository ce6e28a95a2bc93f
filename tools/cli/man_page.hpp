#pragma once
#include <string>

#include "cli/declaration.hpp"

namespace percuss::tools {

/// The name of a command's manual page, "percuss-model-beam".
std::string page_name(const Declaration& all, const DeclaredCommand& command);

/// The manual page of a command in roff, for section 1. It carries the version and no date: the same program gives the
/// same bytes.
std::string man_page(const Declaration& all, const DeclaredCommand& command);

}  // namespace percuss::tools
