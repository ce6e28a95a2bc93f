#include "support/ping_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "core/units.hpp"

namespace percuss::test {
namespace {

constexpr std::uint32_t kRate_Hz = 44100;

void append(std::string& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
}

}  // namespace

const std::vector<PingMode> kPing{{.freq_Hz = 1732.5, .damping_ratio = 0.002, .amplitude = 0.3},
                                  {.freq_Hz = 2141, .damping_ratio = 0.003, .amplitude = 0.2},
                                  {.freq_Hz = 4310, .damping_ratio = 0.004, .amplitude = 0.1}};

std::vector<double> ping(double noise, double factor) {
  std::mt19937 random(2);
  std::normal_distribution<double> gauss;
  std::vector<double> x(kRate_Hz);
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double t = static_cast<double>(n) / kRate_Hz - kBlow_s;
    for (const PingMode& mode : kPing) {
      const double omega = kTwoPi * factor * mode.freq_Hz;
      if (t > 0)
        x[n] +=
            mode.amplitude * std::min(1.0, t / 1e-3) * std::exp(-mode.damping_ratio * omega * t) * std::sin(omega * t);
    }
    x[n] += noise * gauss(random);
  }
  return x;
}

std::string wav_of(const std::vector<double>& x) {
  std::string bytes = "RIFF";
  const auto size = static_cast<std::uint32_t>(2 * x.size());
  append(bytes, 36 + size, 4);
  bytes += "WAVEfmt ";
  append(bytes, 16, 4);
  append(bytes, 1, 2);
  append(bytes, 1, 2);
  append(bytes, kRate_Hz, 4);
  append(bytes, 2 * kRate_Hz, 4);
  append(bytes, 2, 2);
  append(bytes, 16, 2);
  bytes += "data";
  append(bytes, size, 4);
  for (const double value : x)
    append(bytes, static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(32767 * value))), 2);
  return bytes;
}

}  // namespace percuss::test
