#pragma once
#include <cstdint>
#include <string>

namespace percuss::acquire {

/// The largest point number of a file, and of files joined to one test.
constexpr std::int64_t kMaxPointNumber = 1'000'000'000;

/// Whether a whole number is from 0, the number of the geometry's first row, to kMaxPointNumber.
bool is_point_number(std::int64_t point);

/// errors  InputError: not the number of a point; names `where`.
void require_point_number(std::int64_t point, const std::string& where);

}  // namespace percuss::acquire
