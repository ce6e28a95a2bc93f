#include "acquire/record/point_number.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "core/error.hpp"

namespace percuss::acquire {

bool is_point_number(std::int64_t point) { return point >= 0 && point <= kMaxPointNumber; }

void require_point_number(std::int64_t point, const std::string& where) {
  if (is_point_number(point)) return;
  throw InputError(fmt::format("{} is not a point number", point), where,
                   fmt::format("number points from 0 to {}", kMaxPointNumber));
}

void refuse_point_numbers(const std::string& where) { throw InputError("not a whole number", where, "store 0, 1, …"); }

std::vector<int> point_numbers(std::span<const double> numbers, const std::string& where) {
  std::vector<int> points;
  points.reserve(numbers.size());
  for (const double number : numbers) {
    if (!(std::abs(number) <= static_cast<double>(kMaxPointNumber)) || std::rint(number) != number)
      refuse_point_numbers(where);
    points.push_back(static_cast<int>(number));
    require_point_number(points.back(), where);
  }
  if (std::set<int>(points.begin(), points.end()).size() != points.size())
    throw InputError("a point occurs twice", where, "give each point its own number");
  return points;
}

}  // namespace percuss::acquire
