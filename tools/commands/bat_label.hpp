#pragma once
#include <optional>
#include <string>
#include <vector>

#include "report/json/bat_label.hpp"

namespace percuss::tools {

/// The value of --bat-id with those of --bat. None without an id. Throws OptionError.
std::optional<report::BatLabel> bat_label(const std::string& id, const std::vector<std::string>& properties);

}  // namespace percuss::tools
