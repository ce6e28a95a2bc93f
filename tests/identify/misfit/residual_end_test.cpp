#include "identify/misfit/residual_end.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "identify/identify.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::residual_end_test {

// Modes from 120 to 743 Hz, and a stronger one at other_Hz.
FrfDataset set_between(double low_Hz, double high_Hz, double other_Hz) {
  FrfDataset set = test::empty_set(4096, 8192, low_Hz, high_Hz, 2);
  for (std::size_t o = 0; o < 2; ++o) {
    const double sign = o == 0 ? 1 : -0.6;
    test::add_mode(set, o, {120, 0.015}, 0.02);
    test::add_mode(set, o, {656.3, 0.0099}, sign * 0.02);
    test::add_mode(set, o, {743.2, 0.0168}, 0.04);
    test::add_mode(set, o, {other_Hz, 0.006}, sign * 0.2);
  }
  test::add_frf_noise(set, 2e-4, 1);
  return set;
}

std::optional<double> end_between(double low_Hz, double high_Hz, double other_Hz, double misfit_Hz) {
  const FrfDataset set = set_between(low_Hz, high_Hz, other_Hz);
  return growing_end_Hz(set, identify_modes(set), misfit_Hz);
}

TEST(GrowingEnd, IsTheEndBeyondWhichAModeLies) {
  EXPECT_EQ(end_between(8, 975, 1040, 743.2), 975);
  EXPECT_EQ(end_between(28, 975, 20, 120), 28);
}

// The tail of a suspension mode explains no misfit near the upper end.
TEST(GrowingEnd, IsNoneWhereTheMisfitLiesNearTheOtherEnd) {
  EXPECT_EQ(end_between(28, 975, 20, 743.2), std::nullopt);
  EXPECT_EQ(end_between(8, 975, 1040, 80), std::nullopt);
}

TEST(GrowingEnd, IsNoneWhereTheLinesIncludeTheMode) {
  for (const double misfit_Hz : {80.0, 743.2}) {
    EXPECT_EQ(end_between(8, 1200, 1040, misfit_Hz), std::nullopt);
    EXPECT_EQ(end_between(8, 975, 300, misfit_Hz), std::nullopt);
  }
}

TEST(GrowingEnd, IsNoneWhereAModeItselfMisfits) {
  const FrfDataset set = test::frfs_of_changing_mode();
  EXPECT_EQ(growing_end_Hz(set, modes_from_frequencies(set, {320, 502}, Effort::best), 502), std::nullopt);
}

}  // namespace percuss::identify::residual_end_test
