#pragma once
#include <optional>
#include <string_view>
#include <vector>

namespace percuss::tools {

/// The finite numbers of "1200:0.5:3e-3"; nothing for other texts. With `placeholder`, the first may have a unit, as in
/// in_option_unit().
std::optional<std::vector<double>> numbers_between_colons(std::string_view text, std::string_view placeholder = "");

}  // namespace percuss::tools
