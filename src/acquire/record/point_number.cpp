#include "acquire/record/point_number.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace percuss::acquire {

bool is_point_number(std::int64_t point) { return point >= 0 && point <= kMaxPointNumber; }

void require_point_number(std::int64_t point, const std::string& where) {
  if (is_point_number(point)) return;
  throw InputError(fmt::format("{} is not a point number", point), where,
                   fmt::format("number points from 0 to {}", kMaxPointNumber));
}

}  // namespace percuss::acquire
