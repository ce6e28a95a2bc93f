#include "core/math/fft.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/parallel/parallel.hpp"
#include "support/magnitude.hpp"

namespace percuss::fft_test {

constexpr double kRounding = 1e-14;  // of the largest line: a transform's rounding grows as ε √log N, ε = 1.1e-16

std::vector<double> noise(std::size_t samples) {
  std::mt19937_64 generator(samples);
  std::vector<double> x(samples);
  for (double& value : x) value = static_cast<double>(generator() >> 11U) * 0x1p-52 - 1;
  return x;
}

// The defining sum, with the angle reduced before rounding.
std::vector<Complex> by_definition(const std::vector<double>& x) {
  const std::size_t size = x.size();
  std::vector<Complex> out(size / 2 + 1);
  for (std::size_t k = 0; k < out.size(); ++k) {
    for (std::size_t n = 0; n < size; ++n) {
      const double turn = static_cast<double>(k * n % size) / static_cast<double>(size);
      out[k] += x[n] * std::polar(1.0, -2 * std::numbers::pi * turn);
    }
  }
  return out;
}

double largest(const std::vector<Complex>& lines) {
  double out = 0;
  for (const Complex& line : lines) out = std::max(out, std::abs(line));
  return out;
}

TEST(RealDft, OfAnImpulseIsFlatWithLinearPhase) {
  std::vector<double> x(12);
  x[3] = 2;  // a quarter of the length: −90° a line
  const std::vector<Complex> turning = {2.0, {0, -2}, -2.0, {0, 2}, 2.0, {0, -2}, -2.0};
  EXPECT_LE(test::largest_difference(real_dft(x), turning), 2 * kRounding);
}

TEST(RealDft, OfAConstantIsItsSumAtZero) {
  std::vector<Complex> expected(8);
  expected[0] = 15 * 0.25;
  EXPECT_LE(test::largest_difference(real_dft(std::vector<double>(15, 0.25)), expected), 4 * kRounding);
}

TEST(RealDft, OfACosineAndASineIsOneUnscaledLineWithNegativeExponent) {
  constexpr std::size_t kSamples = 40;
  std::vector<double> x(kSamples);
  for (std::size_t n = 0; n < kSamples; ++n) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(n) / kSamples;
    x[n] = 3 * std::cos(4 * turn) + 5 * std::sin(7 * turn);
  }
  std::vector<Complex> expected(kSamples / 2 + 1);
  expected[4] = 3.0 * kSamples / 2;
  expected[7] = {0, -5.0 * kSamples / 2};
  EXPECT_LE(test::largest_difference(real_dft(x), expected), 100 * kRounding);
}

TEST(RealDft, OfOneAndTwoSamplesIsSumAndDifference) {
  EXPECT_EQ(real_dft(std::vector<double>{7}), std::vector<Complex>{7.0});
  EXPECT_EQ(real_dft(std::vector<double>{7, 3}), (std::vector<Complex>{10.0, 4.0}));
}

TEST(RealDft, AgreesWithItsDefinitionForAnyLength) {
  for (const std::size_t size : {3U, 4U, 5U, 17U, 64U, 97U, 210U, 251U, 499U, 512U, 1009U}) {  // primes among them
    const auto x = noise(size);
    const auto exact = by_definition(x);
    const double slack = static_cast<double>(size) * 0x1p-53;  // rounding of the sum itself
    EXPECT_LE(test::largest_difference(real_dft(x), exact), (kRounding + slack) * largest(exact)) << size;
  }
}

TEST(RealDft, KeepsTheEnergy) {
  for (const std::size_t size : {2U, 101U, 4096U, 25601U}) {
    const auto x = noise(size);
    const auto lines = real_dft(x);
    double time = 0, frequency = 0;
    for (const double value : x) time += value * value;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const bool alone = k == 0 || 2 * k == size;  // zero and the Nyquist line have no mirror image
      frequency += (alone ? 1 : 2) * std::norm(lines[k]) / static_cast<double>(size);
    }
    EXPECT_LE(std::abs(frequency - time), 10 * kRounding * time) << size;
  }
}

TEST(RealDft, ScalesExactlyByPowersOfTwo) {
  const auto x = noise(360);
  const auto lines = real_dft(x);
  for (const int power : {-100, 100}) {  // 1e-30 … 1e30
    auto scaled = x;
    for (double& value : scaled) value = std::ldexp(value, power);
    const auto got = real_dft(scaled);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      EXPECT_EQ(got[k].real(), std::ldexp(lines[k].real(), power));
      EXPECT_EQ(got[k].imag(), std::ldexp(lines[k].imag(), power));
    }
  }
}

TEST(RealDft, GivesEqualBytesForAnyAddressAndKeepsItsInput) {
  const auto x = noise(1001);
  std::vector<double> shifted(x.size() + 1);  // 8 bytes off the alignment of vector instructions
  std::copy(x.begin(), x.end(), shifted.begin() + 1);
  EXPECT_EQ(real_dft(std::span(shifted).subspan(1)), real_dft(x));
  EXPECT_TRUE(std::equal(x.begin(), x.end(), shifted.begin() + 1));
}

TEST(RealDft, MayBeCalledByManyThreads) {
  std::vector<std::vector<Complex>> got(24);
  parallel_for(got.size(), 0, [&](std::size_t i) { got[i] = real_dft(noise(700 + i % 3)); });
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_EQ(got[i], real_dft(noise(700 + i % 3)));
}

TEST(RealDft, IsTheSameWithoutAPlan) {
  // Of the largest line: without a plan, each sine and cosine is computed from the one before.
  constexpr double kRoundingOfRecurrence = 1e-12;
  for (const std::size_t size : {1U, 2U, 4U, 1000U, 4096U, 32768U, 65536U}) {
    const std::vector<double> x = noise(size);
    const std::vector<Complex> planned = real_dft(x), once = real_dft_once(x);
    ASSERT_EQ(once.size(), planned.size());
    EXPECT_LE(test::largest_difference(once, planned), kRoundingOfRecurrence * largest(planned)) << size;
  }
}

TEST(InverseRealDft, RestoresTheSamples) {
  for (const std::size_t size : {1U, 2U, 3U, 257U, 1000U, 25601U}) {
    const auto x = noise(size);
    const auto back = inverse_real_dft(real_dft(x), size);
    ASSERT_EQ(back.size(), size);
    for (std::size_t n = 0; n < size; ++n) ASSERT_LE(std::abs(back[n] - x[n]), kRounding) << size;
  }
}

TEST(InverseRealDft, KeepsItsInput) {
  const auto lines = real_dft(noise(90));
  inverse_real_dft(lines, 90);
  EXPECT_EQ(lines, real_dft(noise(90)));
}

bool is_fast(std::size_t length) {
  for (const std::size_t prime : {2U, 3U, 5U, 7U}) {
    while (length % prime == 0) length /= prime;
  }
  return length == 1;
}

TEST(FastLength, IsTheLargestProductOfTwoThreeFiveAndSeven) {
  for (std::size_t n = 1; n <= 3000; ++n) {
    const std::size_t length = fast_length_at_most(n);
    ASSERT_LE(length, n);
    ASSERT_TRUE(is_fast(length)) << n;
    for (std::size_t between = length + 1; between <= n; ++between) ASSERT_FALSE(is_fast(between)) << n;
  }
}

TEST(FastLength, DropsFewSamplesOfALongRecord) {
  EXPECT_EQ(fast_length_at_most(4'608'000), 4'608'000U);  // 180 s at 25.6 kHz
  const std::size_t slow = 4'607'999;                     // 11 · 418909
  EXPECT_LE(static_cast<double>(slow - fast_length_at_most(slow)), 0.01 * static_cast<double>(slow));
}

TEST(RealDft, IsTheSameInScratch) {
  std::vector<double> x(77);
  for (std::size_t n = 0; n < x.size(); ++n) x[n] = std::sin(0.3 * static_cast<double>(n * n));
  for (const std::size_t size : {77U, 12U, 40U}) {  // longer and shorter than the previous one
    const std::span<const double> part(x.data(), size);
    const auto lines = real_dft_in_scratch(part);
    EXPECT_EQ(std::vector<Complex>(lines.begin(), lines.end()), real_dft(part)) << size;
  }
}

}  // namespace percuss::fft_test
