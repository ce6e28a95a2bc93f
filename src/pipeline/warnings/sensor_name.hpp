#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::pipeline {

/// The name of response `channel` on one line, cut after kMaxNameBytes; "accel 1" for the first one if it has no name.
std::string sensor_name(const std::vector<acquire::SignalInfo>& accel, std::size_t channel);

}  // namespace percuss::pipeline
