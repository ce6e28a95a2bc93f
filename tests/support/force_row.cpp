#include "support/force_row.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "synth/pulse.hpp"

namespace percuss::test {

void add_haversine(std::vector<double>& x, double onset, double width, double peak) {
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double phase = (static_cast<double>(n) - onset) / width;
    if (phase <= 0 || phase >= 1) continue;
    x[n] += peak * std::pow(std::sin(std::numbers::pi * phase), 2);
  }
}

void add_filtered_haversine(std::vector<double>& x, double onset, double width, double peak) {
  const synth::Pulse pulse{.kind = synth::PulseKind::haversine, .onset_s = onset, .width_s = width, .peak_N = peak};
  const synth::PulseBasis basis = synth::pulse_basis(pulse, 1, {}, 0, x.size());  // at 1 Hz a second is a sample
  for (std::size_t i = 0; i < basis.force_N.size(); ++i) x[basis.first + i] += basis.force_N[i];
}

void add_noise(std::vector<double>& x, double deviation, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  for (double& value : x) value += deviation * normal(generator);
}

std::vector<double> ac_coupled(const std::vector<double>& x, double time_constant_samples) {
  const double keep = std::exp(-1 / time_constant_samples);
  std::vector<double> out(x.size());
  for (std::size_t n = 1; n < x.size(); ++n) out[n] = keep * (out[n - 1] + x[n] - x[n - 1]);
  return out;
}

acquire::Record force_record(double fs_Hz, const std::vector<std::vector<double>>& force_N) {
  std::vector<std::vector<std::vector<double>>> accel;
  accel.reserve(force_N.size());
  for (const auto& row : force_N) accel.push_back({std::vector<double>(row.size())});
  return acquire::record_in_memory(fs_Hz, force_N, std::move(accel));
}

}  // namespace percuss::test
