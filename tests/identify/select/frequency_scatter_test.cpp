#include "identify/select/frequency_scatter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/modal_frfs.hpp"

namespace percuss::identify::frequency_scatter_test {

constexpr double kNoise = 0.02;  // of lines whose peaks are 1/(2·0.001) = 500 times the residue

using Points = std::vector<std::vector<std::pair<Pole, Complex>>>;

// One channel per point, with separate modes at each point; the force is unknown.
FrfDataset set_of(const Points& points, std::uint64_t seed) {
  FrfDataset set = test::empty_set(4096, 65536, 80, 120, points.size());
  set.points.assign(points.size(), {});
  for (std::size_t p = 0; p < points.size(); ++p) {
    set.channels[p].point = p;
    set.channels[p].channel = 0;
    for (const auto& [pole, residue] : points[p]) test::add_mode(set, p, pole, residue);
  }
  test::add_frf_noise(set, kNoise, seed);
  return set;
}

double shape(int point) { return std::cos(0.4 * point); }

// A mode at 100 Hz (0.1 %: 0.2 Hz wide) whose frequency changes by 0.02 Hz from point to point.
FrfDataset scattering_set(std::uint64_t seed) {
  Points points;
  for (int p = 0; p < 9; ++p) points.push_back({{Pole{100 + 0.02 * (p - 4), 1e-3}, shape(p)}});
  return set_of(points, seed);
}

// Two modes 1.5 bandwidths apart at every point.
FrfDataset pair_set() {
  Points points;
  for (int p = 0; p < 9; ++p)
    points.push_back({{Pole{100, 1e-3}, shape(p)}, {Pole{100.3, 1e-3}, std::sin(0.4 * p + 0.2)}});
  return set_of(points, 3);
}

// The single group of modes, fitted from these poles.
WindowedFit fitted(const FrfDataset& set, const std::vector<Pole>& start) {
  WindowedFit all(set);
  all.replace(start);
  all.sweep();
  EXPECT_EQ(all.groups().size(), 1U);
  return all;
}

TEST(ScatteredModes, AreTheMeanOverThePointsWithItsStandardDeviation) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const FrfDataset set = scattering_set(seed);
    const WindowedFit all = fitted(set, {{100, 1e-3}});
    const auto modes = scattered_modes(all, all.groups().front());
    ASSERT_EQ(modes.size(), 1U) << seed;
    EXPECT_NEAR(modes[0].pole.freq_Hz, 100, 3 * modes[0].freq_std_Hz);
    EXPECT_NEAR(modes[0].pole.damping_ratio, 1e-3, 1e-5) << "a common pole would be broadened by the scatter";
    // The spread of nine frequencies 0.02 Hz apart is 0.055 Hz; the method of moments with unequal weights is accurate
    // to a third.
    EXPECT_NEAR(modes[0].freq_scatter_Hz, 0.055, 0.02);
    EXPECT_NEAR(modes[0].freq_std_Hz, modes[0].freq_scatter_Hz / 3, 2e-3)
        << "the mean of nine points, one of them near a node";
  }
}

TEST(ScatteredModes, KeepTheShape) {
  const FrfDataset set = scattering_set(1);
  const WindowedFit all = fitted(set, {{100, 1e-3}});
  const auto modes = scattered_modes(all, all.groups().front());
  ASSERT_EQ(modes.size(), 1U);
  for (int p = 0; p < 9; ++p)
    EXPECT_NEAR(modes[0].residues.at(static_cast<std::size_t>(p)).real(), shape(p), 0.01) << p;
}

TEST(ScatteredModes, HaveAPoleForEachPointThatLeavesOnlyNoise) {
  const FrfDataset set = scattering_set(2);
  const WindowedFit all = fitted(set, {{100, 1e-3}});
  const FitGroup& group = all.groups().front();
  const auto modes = scattered_modes(all, group);
  ASSERT_EQ(modes.size(), 1U);
  for (std::size_t p = 0; p < 9; ++p) {
    if (std::abs(shape(static_cast<int>(p))) < 0.2) continue;  // hardly observes the mode
    ASSERT_TRUE(modes[0].own_poles[p].has_value()) << p;
    EXPECT_NEAR(modes[0].own_poles[p]->freq_Hz, 100 + 0.02 * (static_cast<double>(p) - 4), 1e-3) << p;
  }
  auto residual = all.residual();
  EXPECT_GT(residual[0].norm(), 20 * kNoise * std::sqrt(2.0 * static_cast<double>(set.lines.count)));
  subtract_freq_scatter(set, group, 0, modes[0], residual);
  // White noise, good to 2 % over this many lines, less the fitted unknowns.
  EXPECT_NEAR(residual[0].norm() / (kNoise * std::sqrt(2.0 * static_cast<double>(set.lines.count))), 1, 0.1);
}

TEST(ScatteredModes, AreAbsentWhereOnlyNoiseDiffers) {
  const FrfDataset set = set_of(Points(9, {{Pole{100, 1e-3}, 1.0}}), 5);
  const WindowedFit all = fitted(set, {{100, 1e-3}});
  EXPECT_TRUE(scattered_modes(all, all.groups().front()).empty());
}

TEST(MergeIfScattered, MergesAPairThatDescribesFrequencyScatter) {
  const FrfDataset set = scattering_set(2);
  const WindowedFit all = fitted(set, {{99.95, 1e-3}, {100.05, 1e-3}});
  const auto one = merge_if_scattered(all, all.groups().front());
  ASSERT_TRUE(one);
  EXPECT_NEAR(one->freq_Hz, 100, 0.1);
}

TEST(MergeIfScattered, LeavesATruePairAlone) {
  const FrfDataset set = pair_set();
  const WindowedFit all = fitted(set, {{100, 1e-3}, {100.3, 1e-3}});
  EXPECT_FALSE(merge_if_scattered(all, all.groups().front()));
  EXPECT_TRUE(scattered_modes(all, all.groups().front()).empty());
}

TEST(MergeIfScattered, NeedsThreePoints) {
  // Each point observes one of two orthogonal modes: the same FRFs as one mode with frequency scatter.
  const FrfDataset set = set_of({{{Pole{100, 1e-3}, 1.0}}, {{Pole{100.1, 1e-3}, 1.0}}}, 1);
  const WindowedFit all = fitted(set, {{100, 1e-3}, {100.1, 1e-3}});
  EXPECT_FALSE(merge_if_scattered(all, all.groups().front()));
}

// Far above the noise, 15 times the energy of the further mode; in the noise, a third more than the noise.
TEST(MaxScatterEnergy, CountsFromTheNoise) {
  EXPECT_DOUBLE_EQ(max_scatter_energy(10, 0), 150);
  EXPECT_DOUBLE_EQ(max_scatter_energy(1, 1), 1.3);
  EXPECT_DOUBLE_EQ(max_scatter_energy(0.9, 1), 1.3);
  EXPECT_DOUBLE_EQ(max_scatter_energy(1.1, 1), 2.5);
}

}  // namespace percuss::identify::frequency_scatter_test
