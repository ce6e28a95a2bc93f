#pragma once
#include <string>

namespace percuss::tools {

/// The word as an argument in a shell: quoted if it is empty or holds other characters than letters, digits and
/// -_./:,=+%@. Control characters stay as they are.
std::string shell_quoted_argument(const std::string& word);

}  // namespace percuss::tools
