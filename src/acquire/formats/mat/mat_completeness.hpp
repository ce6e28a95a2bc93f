#pragma once
#include <string>

namespace percuss::acquire {

enum class MatLevel { v4, v5 };

/// Requires that each variable of a MAT file lies wholly within it: the library fills a truncated variable with zeros.
/// A file that ends between two variables looks complete.
/// errors  InputError: the file ends within a variable.
void require_complete_mat(const std::string& path, MatLevel level);

}  // namespace percuss::acquire
