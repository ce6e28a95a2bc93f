#include "identify/start/cmif.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/modal_frfs.hpp"

namespace percuss::identify::cmif_test {

constexpr double kRounding = 1e-12;

// Two points and two channels; two orthogonal modes at one frequency, and a single mode.
FrfDataset two_by_two() {
  FrfDataset set = test::empty_set(4096, 8192, 50, 1000, 2);
  set.points.push_back(set.points.front());
  for (std::size_t c = 0; c < 2; ++c) {
    set.channels.push_back(set.channels[c]);
    set.channels.back().point = 1;
  }
  const Pole pair{400, 0.01}, alone{700, 0.01};
  for (std::size_t o = 0; o < 4; ++o) {
    test::add_mode(set, o, pair, set.channels[o].point == set.channels[o].channel ? 1.0 : 0.0);
    test::add_mode(set, o, alone, 1.0);
  }
  return set;
}

Eigen::Index line_at(const acquire::LineRange& lines, double freq_Hz) {
  return static_cast<Eigen::Index>(std::lround(freq_Hz / lines.df_Hz()) - static_cast<long>(lines.first));
}

TEST(Cmif, IsTheRootOfTheSumOfSquaresOfOneChannel) {
  FrfDataset set = test::empty_set(4096, 8192, 50, 1000, 1);
  set.points.push_back(set.points.front());
  set.channels.push_back(set.channels[0]);
  set.channels[1].point = 1;
  set.channels[0].frf.assign(set.lines.count, Complex(0, 3));
  set.channels[1].frf.assign(set.lines.count, Complex(-4, 0));
  const Eigen::MatrixXd values = cmif(set, set.lines);
  ASSERT_EQ(values.cols(), 1);
  for (Eigen::Index k = 0; k < values.rows(); ++k) EXPECT_NEAR(values(k, 0), 5, kRounding);
}

TEST(Cmif, ShowsTwoModesOfOneFrequencyInTwoValues) {
  const FrfDataset set = two_by_two();
  const Eigen::MatrixXd values = cmif(set, set.lines);
  ASSERT_EQ(values.cols(), 2);
  const auto pair = values.row(line_at(set.lines, 400)), alone = values.row(line_at(set.lines, 700));
  EXPECT_GT(pair(1), 0.5 * pair(0));
  EXPECT_LT(alone(1), 0.1 * alone(0));
}

TEST(Cmif, CoversTheBandOnly) {
  const FrfDataset set = two_by_two();
  const acquire::LineRange band = frf::lines_in_band(4096, 8192, 300, 500);
  const Eigen::MatrixXd part = cmif(set, band), all = cmif(set, set.lines);
  ASSERT_EQ(static_cast<std::size_t>(part.rows()), band.count);
  EXPECT_EQ(part.row(0), all.row(static_cast<Eigen::Index>(band.first - set.lines.first)));
}

TEST(Cmif, CountsAMissingFrfAsZero) {
  FrfDataset set = two_by_two();
  set.channels.pop_back();
  EXPECT_TRUE(cmif(set, set.lines).allFinite());
}

}  // namespace percuss::identify::cmif_test
