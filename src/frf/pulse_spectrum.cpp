#include "frf/pulse_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <mutex>
#include <numbers>
#include <vector>

#include "core/math/complex.hpp"
#include "core/math/wide_loops.hpp"
#include "core/units.hpp"

namespace percuss::frf {
namespace {

constexpr std::size_t kOversampling = 8;              // length of the pulse's transform over the pulse's length
constexpr std::size_t kKernelWidth = 12;              // spectral lines of the oversampled transform
constexpr std::size_t kMaxSteps = 64, kMinSteps = 8;  // lines of the block per line of the oversampled transform
// Shape parameter of the Kaiser–Bessel kernel. The main lobe of its transform ends where the first alias of the pulse
// begins: at 1 − 0.5/kOversampling of the length of the oversampled transform.
const double kShape =
    std::numbers::pi * static_cast<double>(kKernelWidth) * (1 - 0.5 / static_cast<double>(kOversampling));

// Interpolation weights of the kKernelWidth neighbouring lines, for each of `steps` positions between two lines. Each
// weight is stored twice, for the real and the imaginary part. [steps][kKernelWidth][2]
std::vector<double> kernel(std::size_t steps) {
  std::vector<double> weights;
  weights.reserve(2 * steps * kKernelWidth);
  for (std::size_t step = 0; step < steps; ++step) {
    for (std::size_t t = 0; t < kKernelWidth; ++t) {
      const double away =
          static_cast<double>(t) + 1 - 0.5 * kKernelWidth - static_cast<double>(step) / static_cast<double>(steps);
      const double x = away / (0.5 * kKernelWidth);
      weights.insert(weights.end(), 2, std::cyl_bessel_i(0.0, kShape * std::sqrt(std::max(0.0, 1 - x * x))));
    }
  }
  return weights;
}

// One thread at a time: the Bessel function calls lgamma, which writes a global sign.
const std::vector<double>& cached_kernel(std::size_t steps) {
  static std::mutex mutex;
  static auto& kernels = *new std::map<std::size_t, std::vector<double>>;  // never destroyed
  const std::scoped_lock lock(mutex);
  std::vector<double>& weights = kernels[steps];
  if (weights.empty()) weights = kernel(steps);
  return weights;
}

// The kernel's factor on a sample at this distance from the middle.
double kernel_gain(double samples_off, double grid) {
  const double turn = std::numbers::pi * kKernelWidth * samples_off / grid;
  const double root = std::sqrt(kShape * kShape - turn * turn);
  return kKernelWidth * std::sinh(root) / root;
}

// The number of spectral lines of the block per line of the oversampled transform. 0 where no factor of the block's
// length is suitable.
std::size_t steps_between(std::size_t pulse, std::size_t samples) {
  const std::size_t most = std::min(kMaxSteps, samples / std::max(kOversampling * pulse, 4 * kKernelWidth));
  for (std::size_t steps = most; steps >= kMinSteps; --steps) {
    if (samples % steps == 0 && samples / steps % 2 == 0) return steps;
  }
  return 0;
}

// The oversampled transform: the pulse's transform of length `grid` about its middle sample, from kKernelWidth lines
// below zero to kKernelWidth lines above half of `grid`.
std::vector<Complex> own_transform(std::span<const double> pulse, std::size_t grid) {
  std::vector<double> x(grid);
  const std::size_t middle = pulse.size() / 2;
  for (std::size_t n = 0; n < pulse.size(); ++n) {
    const double off = static_cast<double>(n) - static_cast<double>(middle);
    x[(n + grid - middle) % grid] = pulse[n] / kernel_gain(off, static_cast<double>(grid));
  }
  const std::vector<Complex> half = real_dft(x);
  std::vector<Complex> all;
  all.reserve(half.size() + 2 * kKernelWidth);
  for (std::size_t k = kKernelWidth; k > 0; --k) all.push_back(std::conj(half[k]));
  all.insert(all.end(), half.begin(), half.end());
  for (std::size_t k = 1; k <= kKernelWidth; ++k) all.push_back(std::conj(half[half.size() - 1 - k]));
  return all;
}

// The lines of the block, interpolated between the lines of the pulse's own transform. `middle`: the place in the
// block of the pulse's middle sample, from which its own transform counts.
PERCUSS_WIDE_LOOPS void interpolate(const std::vector<Complex>& own, const std::vector<double>& weights,
                                    std::size_t steps, std::size_t middle, const LineRange& lines,
                                    std::span<Complex> out) {
  const auto turn = [&](std::size_t k) {  // whole turns are removed in integers, without rounding
    return std::polar(1.0,
                      -kTwoPi * static_cast<double>(middle * k % lines.samples) / static_cast<double>(lines.samples));
  };
  const Complex turn_by_line = turn(1);
  constexpr std::size_t kPhaseRestart = 64;  // lines after which the phase is computed anew: its rounding errors add up
  Complex phase;
  const Complex* around = own.data() + lines.first / steps + kKernelWidth + 1 - kKernelWidth / 2;
  std::size_t step = lines.first % steps;
  for (std::size_t i = 0; i < lines.count; ++i) {
    phase = i % kPhaseRestart == 0 ? turn(lines.first + i) : times(phase, turn_by_line);
    FourDoubles sum{}, weight{}, near{};
    for (std::size_t t = 0; t < kKernelWidth; t += 2) {
      std::memcpy(&weight, weights.data() + 2 * (kKernelWidth * step + t), sizeof(weight));
      std::memcpy(&near, around + t, sizeof(near));
      sum += weight * near;
    }
    out[i] = times(phase, {sum[0] + sum[2], sum[1] + sum[3]});
    if (++step < steps) continue;
    step = 0;
    ++around;
  }
}

}  // namespace

bool pulse_spectrum(std::span<const double> pulse, std::size_t offset, const LineRange& lines, std::span<Complex> out) {
  const std::size_t steps = pulse.empty() ? 0 : steps_between(pulse.size(), lines.samples);
  if (steps == 0) return false;
  const std::vector<Complex> own = own_transform(pulse, lines.samples / steps);
  interpolate(own, cached_kernel(steps), steps, offset + pulse.size() / 2, lines, out);
  return true;
}

}  // namespace percuss::frf
