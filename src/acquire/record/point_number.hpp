#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace percuss::acquire {

/// The largest point number of a file, and of files joined to one test.
constexpr std::int64_t kMaxPointNumber = 1'000'000'000;

/// Whether 0 ≤ point ≤ kMaxPointNumber. Point 0 is the first row of the geometry.
bool is_point_number(std::int64_t point);

/// The upper limit of the number of points of a file, given the number of points with coordinates. Without it, a small
/// damaged file could claim much memory: points without coordinates take no bytes in the file.
constexpr std::size_t max_points(std::size_t with_coordinates) { return 4 * with_coordinates + 1000; }

/// errors  InputError: not the number of a point; names `where`.
void require_point_number(std::int64_t point, const std::string& where);

/// The numbers of points that a file stores as floating-point numbers.
/// errors  InputError: a number that is not whole or not a point's, or that occurs twice; names `where`.
std::vector<int> point_numbers(std::span<const double> numbers, const std::string& where);

/// errors  always InputError: the numbers at `where` are not whole
[[noreturn]] void refuse_point_numbers(const std::string& where);

}  // namespace percuss::acquire
