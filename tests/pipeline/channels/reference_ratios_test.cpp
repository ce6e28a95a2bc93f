#include "pipeline/channels/reference_ratios.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace percuss::pipeline::reference_ratios_test {

using testing::IsEmpty;
using testing::SizeIs;

constexpr std::size_t kPoints = 12, kModes = 4;
constexpr double kStd = 1e-3;  // of residues of size 1
constexpr double kRounding = 1e-12;

// Four bending modes of a beam, with two sensors near its left end.
std::vector<identify::Mode> beam_modes(const std::function<double(std::size_t point, std::size_t channel)>& factor) {
  std::vector<identify::Mode> modes(kModes);
  for (std::size_t m = 0; m < kModes; ++m) {
    const auto shape = [m](double x) { return std::cos(3.0 * static_cast<double>(m + 1) * x); };
    for (std::size_t p = 0; p < kPoints; ++p) {
      for (std::size_t c = 0; c < 2; ++c) {
        const double at_sensor = shape(c == 0 ? 0.0 : 0.05);
        modes[m].residues.push_back({.point = p,
                                     .channel = c,
                                     .value = factor(p, c) * shape(static_cast<double>(p) / kPoints) * at_sensor,
                                     .std = kStd});
      }
    }
  }
  return modes;
}

TEST(ReferenceRatios, AgreeAtAllPoints) {
  EXPECT_THAT(reference_contradictions(beam_modes([](std::size_t, std::size_t) { return 1.0; })), IsEmpty());
  EXPECT_THAT(reference_contradictions(beam_modes([](std::size_t, std::size_t c) { return c == 1 ? -9.8 : 1.0; })),
              IsEmpty())
      << "a sensor that differs at all points has the same ratio at all";
  EXPECT_THAT(reference_contradictions(beam_modes([](std::size_t p, std::size_t) { return p == 3 ? 1000.0 : 1.0; })),
              IsEmpty())
      << "the force concerns both sensors";
}

TEST(ReferenceRatios, ContradictAtThePointOfAWrongChannel) {
  for (const double wrong : {-1.0, 9.80665, 0.001, 0.0}) {
    const auto found = reference_contradictions(
        beam_modes([&](std::size_t p, std::size_t c) { return p == 5 && c == 1 ? wrong : 1.0; }));
    ASSERT_EQ(found.size(), 1U) << wrong;
    EXPECT_EQ(found[0].point, 5U);
    EXPECT_EQ(found[0].first, 0U);
    EXPECT_EQ(found[0].second, 1U);
    EXPECT_NEAR(found[0].factor, wrong, kRounding);
    EXPECT_GE(found[0].modes, 3U);
  }
}

// A factor that differs from mode to mode has another cause, such as close modes.
TEST(ReferenceRatios, DoNotContradictWhereTheModesDisagree) {
  auto modes = beam_modes([](std::size_t, std::size_t) { return 1.0; });
  for (std::size_t m = 0; m < kModes; ++m) {
    for (identify::Residue& residue : modes[m].residues) {
      if (residue.point == 5 && residue.channel == 1) residue.value *= 1.0 + 2.0 * static_cast<double>(m);
    }
  }
  EXPECT_THAT(reference_contradictions(modes), IsEmpty());
}

// The sensor was mounted the other way round for the last five of twelve points, or for the first seven. Both times,
// the five points are named, because they are the smaller group.
TEST(ReferenceRatios, NameTheSmallerGroupOfPoints) {
  for (const bool last : {true, false}) {
    const auto found = reference_contradictions(
        beam_modes([&](std::size_t p, std::size_t c) { return c == 1 && (last ? p >= 7 : p < 7) ? -1.0 : 1.0; }));
    EXPECT_THAT(found, SizeIs(5)) << last;
    for (const ReferenceContradiction& at : found) {
      EXPECT_GE(at.point, 7U);
      EXPECT_NEAR(at.factor, -1, kRounding);
    }
  }
}

TEST(ReferenceRatios, FindEitherChannelSilent) {
  for (const std::size_t silent : {0U, 1U}) {
    const auto found = reference_contradictions(
        beam_modes([&](std::size_t p, std::size_t c) { return p == 9 && c == silent ? 0.0 : 1.0; }));
    ASSERT_THAT(found, SizeIs(1)) << silent;
    EXPECT_EQ(found[0].point, 9U);
    EXPECT_EQ(found[0].second, silent);
    EXPECT_NEAR(found[0].factor, 0, kRounding);
  }
}

}  // namespace percuss::pipeline::reference_ratios_test
