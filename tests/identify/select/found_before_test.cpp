#include "identify/select/found_before.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "identify/fit/joint_fit.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::found_before_test {

constexpr std::size_t kPoints = 10;
constexpr double kNoise = 1e-3;  // a peak is 50 times its residue
constexpr Pole kMode{.freq_Hz = 200, .damping_ratio = 0.01}, kBeside{.freq_Hz = 202, .damping_ratio = 0.01};

// One mode, kMode, was found before; its frequency scatters by 0.1 Hz. The fit of both poles leaves 0.4 of the residual
// energy of this one mode with a pole of its own at each point, so that the scatter could explain both poles.
std::vector<std::size_t> partners(double share) {
  FrfDataset set = test::empty_set(4096, 8192, 100, 500, kPoints);
  set.points.resize(kPoints);
  for (std::size_t o = 0; o < kPoints; ++o) {
    set.channels[o].point = o;
    set.channels[o].channel = 0;
    test::add_mode(set, o, kMode, 1);
    test::add_mode(set, o, kBeside, share);
    // A misfit above the noise, which neither fit describes.
    for (std::size_t k = 0; k < set.lines.count; ++k) set.channels[o].frf[k] += k / 40 % 2 == 0 ? 0.5 : -0.5;
  }
  test::add_frf_noise(set, kNoise, 1);
  const JointFit fit = fit_residues(set, {kMode, kBeside});
  FittedMode known;
  known.mode.pole = kMode;
  known.mode.freq_scatter_Hz = 0.1;
  known.first = set.lines.nearest(180);
  known.count = set.lines.nearest(220) - known.first;
  known.noise.resize(static_cast<Eigen::Index>(kPoints));
  for (std::size_t o = 0; o < kPoints; ++o) {
    const auto residual =
        fit.residual[o].segment(static_cast<Eigen::Index>(known.first), static_cast<Eigen::Index>(known.count));
    known.noise(static_cast<Eigen::Index>(o)) = residual.norm() / std::sqrt(0.4 * static_cast<double>(known.count));
  }
  return scatter_partners(set, {known}, fit);
}

TEST(ScatterPartners, AreSmallBesideTheirMode) { EXPECT_EQ(partners(0.1), (std::vector<std::size_t>{1})); }

// To move the mode by 0.1 Hz, a pole 2 Hz beside it needs a twentieth of the residues.
TEST(ScatterPartners, AreNotModesOfTheSameSize) { EXPECT_TRUE(partners(0.8).empty()); }

}  // namespace percuss::identify::found_before_test
