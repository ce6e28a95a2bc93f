// The record of one sine of 3 periods, as a user's program would hand it to percuss: line 3 of its transform must be
// −jN/2.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "acquire/record/record.hpp"
#include "core/math/fft.hpp"

int main() {
  constexpr std::size_t kSamples = 64;
  std::vector<double> sine(kSamples);
  for (std::size_t n = 0; n < kSamples; ++n) {
    sine[n] = std::sin(2 * std::numbers::pi * 3 * static_cast<double>(n) / kSamples);
  }
  const percuss::Record record = percuss::record_in_memory(1000, {sine}, {{sine}});
  std::vector<double> force(record.rows.at(0).samples);
  record.read_force_N(0, 0, force);
  const auto error = std::abs(percuss::real_dft(force).at(3) - percuss::Complex(0, -32));
  std::printf("line 3 is off by %.1e\n", error);
  return error <= 1e-12 ? 0 : 1;  // 64 additions of rounded values near 1
}
