#include "acquire/record/frf.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"

namespace percuss::acquire::frf_test {

constexpr double kRounding = 1e-15;  // of one division

LineRange lines(std::size_t first) { return {.fs_Hz = 1000, .samples = 500, .first = first, .count = 3}; }

Frf accelerance() {
  return {.value = {{3, -1}, {0.5, 2}, {-7, 0}}, .std = {0.1, 0.2, 0.3}, .coherence = {0.9, 0.8, 1}, .averages = 5};
}

TEST(Converted, DividesByJOmega) {
  const Frf mobility = converted(accelerance(), lines(40), FrfKind::mobility);
  const Frf receptance = converted(accelerance(), lines(40), FrfKind::receptance);
  for (std::size_t k = 0; k < 3; ++k) {
    const double omega = kTwoPi * (80 + 2 * static_cast<double>(k));
    const Complex a = accelerance().value[k];
    EXPECT_LE(std::abs(mobility.value[k] - Complex(a.imag(), -a.real()) / omega), kRounding * std::abs(a) / omega);
    EXPECT_LE(std::abs(receptance.value[k] + a / (omega * omega)), 3 * kRounding * std::abs(a) / (omega * omega));
    EXPECT_DOUBLE_EQ(mobility.std[k], accelerance().std[k] / omega);
    EXPECT_DOUBLE_EQ(receptance.std[k], accelerance().std[k] / (omega * omega));
  }
  EXPECT_EQ(mobility.coherence, accelerance().coherence);
  EXPECT_EQ(mobility.averages, 5U);
}

TEST(Converted, IsReceptanceWhenDividedTwice) {
  const Frf once = converted(accelerance(), lines(9), FrfKind::mobility, 12);
  const Frf twice = converted(once, lines(9), FrfKind::mobility, 12);
  const Frf receptance = converted(accelerance(), lines(9), FrfKind::receptance, 12);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LE(std::abs(twice.value[k] / receptance.value[k] - 1.0), 4 * kRounding);
  }
}

TEST(Converted, MultipliedBackIsTheAccelerance) {
  const Frf receptance = converted(accelerance(), lines(9), FrfKind::receptance, 35);
  for (std::size_t k = 0; k < 3; ++k) {
    const Complex s(35, kTwoPi * (18 + 2 * static_cast<double>(k)));  // the window's decay on the real axis
    EXPECT_LE(std::abs(receptance.value[k] * s * s / accelerance().value[k] - 1.0), 4 * kRounding);
    EXPECT_LE(std::abs(receptance.std[k] * std::norm(s) / accelerance().std[k] - 1), 4 * kRounding);
  }
}

TEST(Converted, LeavesItsInputAndAnAcceleranceUnchanged) {
  const Frf input = accelerance();
  const Frf mobility = converted(input, lines(9), FrfKind::mobility);
  EXPECT_EQ(input.value, accelerance().value);
  EXPECT_EQ(input.std, accelerance().std);
  EXPECT_NE(mobility.value, input.value);
  EXPECT_EQ(converted(input, lines(9), FrfKind::accelerance, 7).value, input.value);
}

TEST(Converted, IsZeroAtZeroFrequencyWithoutAWindow) {
  for (const FrfKind kind : {FrfKind::mobility, FrfKind::receptance}) {
    const Frf still = converted(accelerance(), lines(0), kind);
    EXPECT_EQ(still.value[0], 0.0);
    EXPECT_EQ(still.std[0], 0);
    EXPECT_TRUE(std::abs(still.value[1]) > 0);
    const double divisor = kind == FrfKind::mobility ? 10 : 100;
    const Frf moved = converted(accelerance(), lines(0), kind, 10);
    EXPECT_LE(std::abs(moved.value[0] - accelerance().value[0] / divisor), kRounding);
  }
}

TEST(Converted, TakesAnFrfOfOneHit) {
  Frf single = accelerance();
  single.std.clear();
  single.coherence.clear();
  EXPECT_TRUE(converted(single, lines(5), FrfKind::receptance).std.empty());
}

TEST(FrfKind, HasTheUsualNamesAndUnits) {
  EXPECT_STREQ(name_of(FrfKind::accelerance), "accelerance");
  EXPECT_STREQ(name_of(FrfKind::mobility), "mobility");
  EXPECT_STREQ(name_of(FrfKind::receptance), "receptance");
  EXPECT_STREQ(unit_of(FrfKind::accelerance), "(m/s^2)/N");
  EXPECT_STREQ(unit_of(FrfKind::mobility), "(m/s)/N");
  EXPECT_STREQ(unit_of(FrfKind::receptance), "m/N");
}

}  // namespace percuss::acquire::frf_test
