#include "frf/windows.hpp"

#include <cmath>

namespace percuss::frf {

void apply_exponential(std::span<double> x, double decay_per_s, double fs_Hz, double origin) {
  if (decay_per_s == 0) return;
  for (std::size_t n = 0; n < x.size(); ++n) x[n] *= std::exp(-decay_per_s * (static_cast<double>(n) - origin) / fs_Hz);
}

double decay_for_end(double fraction, double duration_s) { return -std::log(fraction) / duration_s; }

}  // namespace percuss::frf
