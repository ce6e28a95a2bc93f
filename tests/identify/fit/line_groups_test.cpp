#include "identify/fit/line_groups.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/modal_frfs.hpp"

namespace percuss::identify::line_groups_test {

const acquire::LineRange kLines{.fs_Hz = 8192, .samples = 16384, .first = 100, .count = 4000};

TEST(LineGroups, KeepTheMeanPowerOfWhiteNoise) {
  constexpr double kTolerance = 0.1;  // of a variance from a thousand groups: three standard deviations
  const LineGroups groups(kLines, {{400, 0.005}, {1500, 0.002}});
  FrfDataset set = test::empty_set(kLines.fs_Hz, kLines.samples, 50, 2049.5, 1);
  ASSERT_EQ(set.lines.count, kLines.count);
  double energy = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    set.channels[0].frf.assign(set.lines.count, Complex());
    test::add_frf_noise(set, 1, seed);
    Eigen::VectorXd column(2 * groups.count());
    const Eigen::Map<const Eigen::VectorXcd> z(set.channels[0].frf.data(), static_cast<Eigen::Index>(kLines.count));
    groups.sum(z, Eigen::VectorXd::Ones(z.size()), column);
    energy += column.squaredNorm() / static_cast<double>(column.size()) / 4;
  }
  EXPECT_LE(std::abs(energy - 1), kTolerance);
}

TEST(LineGroups, LoseAlmostNoInformationAboutAPole) {
  // Fisher information of frequency, damping and residue, with and without groups.
  const Pole pole{800.3, 0.004};
  const LineGroups groups(kLines, {pole});
  EXPECT_LE(groups.count(), 400);  // a tenth of the lines; 212
  const PointForce none;
  const ModeColumn mode = mode_column(pole, none, kLines, 0, kLines.count);
  const Eigen::VectorXd equal_weights = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(kLines.count));
  constexpr double kLoss = 0.003;  // as line_groups.hpp states; here 3e-5
  for (const Eigen::VectorXcd& z : {mode.by_freq, mode.by_damping, mode.value}) {
    Eigen::VectorXd column(2 * groups.count());
    groups.sum(z, equal_weights, column);
    EXPECT_LE(std::abs(column.squaredNorm() / z.squaredNorm() - 1), kLoss);
  }
}

TEST(LineGroups, CoverEveryLineOnce) {
  const LineGroups groups(kLines, {{60, 0.01}, {2040, 0.02}});
  Eigen::VectorXd column(2 * groups.count());
  const Eigen::VectorXd equal_weights = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(kLines.count));
  groups.sum(equal_weights.cast<Complex>(), equal_weights, column);
  // A group of n lines gives n/√n: the squares count the lines.
  constexpr double kRounding = 1e-8;
  EXPECT_LE(std::abs(column.squaredNorm() - static_cast<double>(kLines.count)), kRounding);
  EXPECT_EQ(groups.middles().size(), static_cast<std::size_t>(groups.count()));
}

}  // namespace percuss::identify::line_groups_test
