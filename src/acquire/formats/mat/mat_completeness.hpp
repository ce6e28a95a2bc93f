#pragma once
#include <cstddef>
#include <optional>
#include <string>

namespace percuss::acquire {

enum class MatLevel { v4, v5 };

/// Requires that each variable of a MAT file lies wholly within it: the library fills a truncated variable with zeros.
/// A file that ends between two variables looks complete. Returns the number of variables, or nothing if the file holds
/// an element of another type.
/// errors  InputError: the file ends within a variable.
std::optional<std::size_t> require_complete_mat(const std::string& path, MatLevel level);

}  // namespace percuss::acquire
