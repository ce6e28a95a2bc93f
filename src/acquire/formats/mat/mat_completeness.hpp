#pragma once
#include <string>

namespace percuss::acquire {

enum class MatLevel { v4, v5 };

/// Sees to it that every variable of a MAT file lies wholly in it: of one that was cut off the library gives the
/// numbers that are there and zeros. A file that ends between two variables cannot be told from one that never had
/// more. errors  InputError: it ends within one.
void require_complete_mat(const std::string& path, MatLevel level);

}  // namespace percuss::acquire
