#include "pipeline/warnings/sensor_name.hpp"

#include "acquire/record/channel_name.hpp"
#include "core/error.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

std::string sensor_name(const std::vector<acquire::SignalInfo>& accel, std::size_t channel) {
  if (channel >= accel.size() || accel[channel].name.empty()) return acquire::channel_name(channel);
  return one_line(accel[channel].name, kMaxNameBytes);
}

}  // namespace percuss::pipeline
