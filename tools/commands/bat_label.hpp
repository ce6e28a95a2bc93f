#pragma once
#include <optional>
#include <string>
#include <vector>

#include "report/json/bat_label.hpp"

namespace percuss::tools {

/// The id of --bat-id and the properties of --bat as one label; nothing without an id. Throws OptionError.
std::optional<report::BatLabel> bat_label(const std::string& id, const std::vector<std::string>& properties);

}  // namespace percuss::tools
