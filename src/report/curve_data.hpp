#pragma once
#include <nlohmann/json_fwd.hpp>
#include <span>

namespace percuss {

/// Numbers for a picture: {"from", "step", "u16"}, value = from + step · k with k the little-endian 16-bit numbers in
/// base64; 65535 is not a number. `step` is the range over 65534, or `coarsest` where that is finer than anybody sees.
nlohmann::ordered_json picture_numbers(std::span<const double> values, double coarsest);

}  // namespace percuss
