#include "metrics/deflection/laplace_transform.hpp"

#include <cmath>

#include "core/units.hpp"

namespace percuss::metrics {
namespace {

// Exponent of the window's decay over the padded length. A response that wraps around is damped to e^−30 = 1e-13.
// Division by the window raises rounding at the last sample by at most e^15, to less than 1e-9.
constexpr double kWindowEnd = 30;

}  // namespace

LaplaceTransform::LaplaceTransform(std::span<const double> x, double fs_Hz)
    : fs_Hz_(fs_Hz),
      samples_(x.size()),
      padded_(padded_length(x.size())),
      decay_per_s_(kWindowEnd * fs_Hz / static_cast<double>(padded_)) {
  std::vector<double> windowed(padded_);
  for (std::size_t i = 0; i < samples_; ++i) windowed[i] = x[i] * window(i);
  lines_ = real_dft(windowed);
}

std::size_t LaplaceTransform::padded_length(std::size_t samples) { return fast_length_at_least(2 * samples); }

double LaplaceTransform::window(std::size_t sample) const {
  return std::exp(-decay_per_s_ * static_cast<double>(sample) / fs_Hz_);
}

std::vector<double> LaplaceTransform::response(const std::function<Complex(Complex s)>& transfer) const {
  std::vector<Complex> scaled(lines_.size());
  const double step = kTwoPi * fs_Hz_ / static_cast<double>(padded_);
  for (std::size_t k = 0; k < lines_.size(); ++k)
    scaled[k] = lines_[k] * transfer(Complex(decay_per_s_, static_cast<double>(k) * step));
  std::vector<double> y = inverse_real_dft(scaled, padded_);
  y.resize(samples_);
  for (std::size_t i = 0; i < samples_; ++i) y[i] /= window(i);
  return y;
}

}  // namespace percuss::metrics
