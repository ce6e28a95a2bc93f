#include "acquire/formats/mat/mat_sensors.hpp"

#include "acquire/record/sensor_numbers.hpp"
#include "core/units.hpp"

namespace percuss::acquire {

void write_mat_sensors(MatOutput& out, const std::vector<SignalInfo>& accel) {
  const auto angle_deg = sensor_numbers(accel, &SignalInfo::angle_rad, kRadian_deg);
  const auto position_m = sensor_numbers(accel, &SignalInfo::position_m);
  if (!angle_deg.empty()) out.numbers("angle_deg", angle_deg);
  if (!position_m.empty()) out.numbers("position_m", position_m);
}

}  // namespace percuss::acquire
