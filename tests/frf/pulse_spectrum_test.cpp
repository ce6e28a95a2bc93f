#include "frf/pulse_spectrum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/math/fft.hpp"
#include "synth/random_stream.hpp"

namespace percuss::frf::pulse_spectrum_test {

std::vector<double> noise(std::size_t samples) {
  std::vector<double> x(samples);
  synth::RandomStream({samples, 1}).add_normal(1.0, x);
  return x;
}

struct Place {
  std::size_t pulse, offset, samples;
};

constexpr double kRounding = 1e-13;  // of the largest line: the kernel's images are at 2e-14

class PulseSpectrum : public testing::TestWithParam<Place> {};

// White noise is the hardest pulse: no part of its spectrum is small.
TEST_P(PulseSpectrum, IsTheTransformOfTheWholeBlock) {
  const auto [length, offset, samples] = GetParam();
  const std::vector<double> pulse = noise(length);
  std::vector<double> block(samples);
  std::copy(pulse.begin(), pulse.end(), block.begin() + static_cast<std::ptrdiff_t>(offset));
  const std::vector<Complex> exact = real_dft(block);
  double largest = 0;
  for (const Complex& line : exact) largest = std::max(largest, std::abs(line));
  for (const std::size_t first : {std::size_t{0}, samples / 5}) {
    const LineRange lines{.fs_Hz = 1000, .samples = samples, .first = first, .count = exact.size() - first};
    std::vector<Complex> spectrum(lines.count);
    ASSERT_TRUE(pulse_spectrum(pulse, offset, lines, spectrum));
    for (std::size_t i = 0; i < lines.count; ++i)
      ASSERT_LE(std::abs(spectrum[i] - exact[first + i]), kRounding * largest) << "line " << first + i;
  }
}

INSTANTIATE_TEST_SUITE_P(WhereverThePulseIs, PulseSpectrum,
                         testing::Values(Place{1, 0, 4096}, Place{1, 4095, 4096}, Place{2, 17, 640},
                                         Place{63, 100, 25600}, Place{256, 1600, 32768}, Place{255, 32513, 32768},
                                         Place{100, 3, 48000}, Place{97, 40000, 96000}));

TEST(PulseSpectrumSavings, AreNoneForLongPulsesAndPrimeBlocks) {
  std::vector<Complex> out(100);
  EXPECT_FALSE(pulse_spectrum(noise(4000), 10, {.fs_Hz = 1, .samples = 32768, .count = 100}, out));
  EXPECT_FALSE(pulse_spectrum(noise(10), 10, {.fs_Hz = 1, .samples = 32749, .count = 100}, out));
  EXPECT_FALSE(pulse_spectrum({}, 10, {.fs_Hz = 1, .samples = 32768, .count = 100}, out));
}

}  // namespace percuss::frf::pulse_spectrum_test
