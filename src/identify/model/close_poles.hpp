#pragma once
#include <algorithm>
#include <cmath>

#include "identify/model/modal_model.hpp"

namespace percuss::identify {

/// Whether the frequencies differ by less than the wider half-power bandwidth.
inline bool are_close(const Pole& a, const Pole& b) {
  return std::abs(a.freq_Hz - b.freq_Hz) < std::max(a.half_power_Hz(), b.half_power_Hz());
}

}  // namespace percuss::identify
