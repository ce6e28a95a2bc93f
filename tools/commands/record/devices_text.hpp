#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "acquire/live/list_devices.hpp"

namespace percuss::tools {

/// The table of recording devices as text, or advice if there is none.
std::string devices_text(const std::vector<acquire::ListedDevice>& devices, std::size_t width);

}  // namespace percuss::tools
