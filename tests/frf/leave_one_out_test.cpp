#include "frf/leave_one_out.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <utility>

namespace percuss::frf::leave_one_out_test {

using Lines = std::vector<Complex>;

/// force [hits][lines], accel [hits][channels][lines].
std::vector<double> unexplained(const std::vector<Lines>& force, const std::vector<std::vector<Lines>>& accel) {
  using Spans = std::vector<std::span<const Complex>>;
  std::vector<Spans> a;
  a.reserve(accel.size());
  for (const auto& channels : accel) a.emplace_back(channels.begin(), channels.end());
  return leave_one_out_error(Spans(force.begin(), force.end()), a);
}

const std::vector<Lines> kForce = {{1.0, Complex(0, 2)}, {-3.0, 1.0}, {Complex(1, 1), 5.0}};

/// A = H F with an FRF for each of two channels and two lines, times `gain` for each hit.
std::vector<std::vector<Lines>> responses(const std::vector<double>& gain, double scale = 1) {
  std::vector<std::vector<Lines>> out;
  for (std::size_t h = 0; h < gain.size(); ++h) {
    const Lines& f = kForce[h];
    const double g = gain[h] * scale;
    out.push_back({{g * Complex(2, 1) * f[0], g * 3.0 * f[1]}, {g * Complex(0, -4) * f[0], g * 0.5 * f[1]}});
  }
  return out;
}

TEST(LeaveOneOutError, IsZeroWhenAllHitsAgree) {
  constexpr double kRounding = 1e-28;  // of energies
  for (const double error : unexplained(kForce, responses({1, 1, 1}))) EXPECT_LE(error, kRounding);
}

TEST(LeaveOneOutError, IsTheEnergyOfTheDifferenceFromTheOtherHitsFrf) {
  const std::vector<Lines> alike(3, Lines{2.0});
  const auto error = unexplained(alike, {{{6.0}}, {{6.0}}, {{-6.0}}});
  EXPECT_DOUBLE_EQ(error[2], 4);  // −3 where the other hits predict 3
  EXPECT_DOUBLE_EQ(error[0], 1);  // 3 where the other hits predict 0
  EXPECT_DOUBLE_EQ(error[1], 1);
}

TEST(LeaveOneOutError, WeighsChannelsAndLinesByTheirEnergy) {
  const std::vector<Lines> alike(2, Lines{1.0, 1.0});
  const auto error = unexplained(alike, {{{1.0, 2.0}, {0.0, 3.0}}, {{1.0, 2.0}, {4.0, 3.0}}});
  EXPECT_DOUBLE_EQ(error[0], 16.0 / 14);  // the hits differ in one line, by 4; the energy of hit 0 is 1 + 4 + 9
  EXPECT_DOUBLE_EQ(error[1], 16.0 / 30);
}

TEST(LeaveOneOutError, DoesNotDependOnUnitsOrTheOrderOfHits) {
  const auto plain = unexplained(kForce, responses({1, 1.2, 0.7}));
  for (const double scale : {-1.0, 1e-30, 1e30}) {
    const auto scaled = unexplained(kForce, responses({1, 1.2, 0.7}, scale));
    constexpr double kRounding = 1e-12;  // of differences of a few products
    for (std::size_t h = 0; h < 3; ++h) EXPECT_LE(std::abs(scaled[h] / plain[h] - 1), kRounding);
  }
  auto accel = responses({1, 1.2, 0.7});
  auto force = kForce;
  std::swap(force[0], force[2]);
  std::swap(accel[0], accel[2]);
  const auto swapped = unexplained(force, accel);
  constexpr double kRounding = 1e-12;  // as above
  EXPECT_LE(std::abs(swapped[0] / plain[2] - 1), kRounding);
  EXPECT_LE(std::abs(swapped[1] / plain[1] - 1), kRounding);
}

TEST(LeaveOneOutError, NeedsTwoHitsAndAResponse) {
  EXPECT_EQ(unexplained({kForce[0]}, {responses({1})[0]}), std::vector<double>{0});
  EXPECT_TRUE(unexplained({}, {}).empty());
  const auto silent = unexplained({kForce[0], kForce[1]}, responses({0, 0}));
  EXPECT_EQ(silent, (std::vector<double>{0, 0}));
}

}  // namespace percuss::frf::leave_one_out_test
