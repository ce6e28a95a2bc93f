#include "acquire/record/sensor_numbers.hpp"

#include <algorithm>
#include <limits>

namespace percuss::acquire {

std::vector<double> sensor_numbers(const std::vector<SignalInfo>& accel, std::optional<double> SignalInfo::*place,
                                   double factor) {
  const auto known = [&](const SignalInfo& signal) { return (signal.*place).has_value(); };
  if (std::none_of(accel.begin(), accel.end(), known)) return {};
  std::vector<double> out;
  out.reserve(accel.size());
  for (const SignalInfo& signal : accel)
    out.push_back(known(signal) ? *(signal.*place) * factor : std::numeric_limits<double>::quiet_NaN());
  return out;
}

}  // namespace percuss::acquire
