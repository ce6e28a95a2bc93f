#include "identify/shapes/scan_scatter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.hpp"
#include "identify/shapes/nodes.hpp"
#include "synth/structure.hpp"

namespace percuss::identify::scan_scatter_test {

constexpr double kLength_m = 0.84;
constexpr double kNoise = 1e-4;

double shape_at(int order, double x_m) { return synth::free_beam_shape(order, x_m / kLength_m); }

// A scan in half inches of the first `modes` bending modes; every hit lands beside its place.
std::vector<HitsAlongScan> scan_of(std::mt19937& random, int modes, std::size_t hits, double position_std_m,
                                   double relative_std) {
  std::normal_distribution<double> normal;
  std::vector<HitsAlongScan> out(static_cast<std::size_t>(modes));
  for (double x_m = 3 * kInch_m; x_m < 9.01 * kInch_m; x_m += 0.5 * kInch_m) {
    std::vector<double> place_m, gain;
    for (std::size_t h = 0; h < hits; ++h) {
      place_m.push_back(x_m + position_std_m * normal(random));
      gain.push_back(1 + relative_std * normal(random));
    }
    for (int m = 0; m < modes; ++m) {
      HitsAlongScan& mode = out[static_cast<std::size_t>(m)];
      std::vector<AmplitudeOfHit> at;
      double mean = 0;
      for (std::size_t h = 0; h < hits; ++h) {
        at.push_back({.value = gain[h] * shape_at(m + 1, place_m[h]) + kNoise * normal(random), .std = kNoise});
        mean += at.back().value / static_cast<double>(hits);
      }
      mode.shape.position_m.push_back(x_m);
      mode.shape.amplitude.push_back(mean);
      mode.shape.std.push_back(kNoise / std::sqrt(static_cast<double>(hits)));
      mode.hits.push_back(at);
    }
  }
  return out;
}

TEST(ScatterAlongScan, FindsTheScatterOfTheHits) {
  std::mt19937 random(1);
  constexpr int kScans = 200;
  double position2 = 0, relative2 = 0;
  for (int i = 0; i < kScans; ++i) {
    const auto scatter = scatter_along_scan(scan_of(random, 3, 3, 2e-3, 0.03));
    ASSERT_EQ(scatter.size(), 3U);
    EXPECT_EQ(scatter[0].degrees_of_freedom, 26) << "13 points with three hits";
    EXPECT_EQ(scatter[2].position_std_m, scatter[0].position_std_m) << "common to all modes";
    EXPECT_LT(scatter[0].of_amplitude, 0.2);
    position2 += scatter[0].position_std_m * scatter[0].position_std_m / kScans;
    relative2 += scatter[0].relative_std * scatter[0].relative_std / kScans;
  }
  constexpr double kScatterOfMean = 0.1;  // five standard deviations of a variance with 26·200 degrees of freedom
  EXPECT_NEAR(position2 / 4e-6, 1, kScatterOfMean);
  EXPECT_NEAR(relative2 / 9e-4, 1, kScatterOfMean);
}

// A mode of the other plane: its sign in a hit is that of the hit's direction.
void add_mode_of_direction(std::mt19937& random, std::vector<HitsAlongScan>& modes, int order) {
  std::normal_distribution<double> normal;
  HitsAlongScan& mode = modes.emplace_back(modes.front());
  for (std::size_t p = 0; p < mode.hits.size(); ++p) {
    double mean = 0;
    for (AmplitudeOfHit& hit : mode.hits[p]) {
      hit.value = 0.03 * normal(random) * shape_at(order, mode.shape.position_m[p]) + kNoise * normal(random);
      mean += hit.value / static_cast<double>(mode.hits[p].size());
    }
    mode.shape.amplitude[p] = mean;
  }
}

TEST(ScatterAlongScan, LeavesOutModesThatDependOnTheDirection) {
  std::mt19937 random(5);
  int apart = 0;
  constexpr int kScans = 100;
  for (int i = 0; i < kScans; ++i) {
    auto modes = scan_of(random, 3, 3, 2e-3, 0.01);
    const auto alone = scatter_along_scan(modes);
    add_mode_of_direction(random, modes, 1);
    add_mode_of_direction(random, modes, 2);
    const auto scatter = scatter_along_scan(modes);
    ASSERT_EQ(scatter.size(), 5U);
    for (std::size_t m = 0; m < 3; ++m) {
      EXPECT_EQ(scatter[m].position_std_m, alone[m].position_std_m) << "scan " << i << ", mode " << m;
      EXPECT_EQ(scatter[m].relative_std, alone[m].relative_std) << "scan " << i << ", mode " << m;
      EXPECT_LT(scatter[m].of_amplitude, 0.2);
    }
    for (std::size_t m = 3; m < 5; ++m) apart += scatter[m].of_amplitude > 0.5 ? 1 : 0;
  }
  EXPECT_GE(apart, 2 * kScans * 95 / 100);
}

TEST(ScatterAlongScan, IsNothingForHitsThatOnlyNoiseTellsApart) {
  std::mt19937 random(2);
  int found = 0;
  for (int i = 0; i < 200; ++i) found += scatter_along_scan(scan_of(random, 2, 2, 0, 0)).empty() ? 0 : 1;
  EXPECT_LE(found, 2) << "once in 1000 by chance";
  EXPECT_TRUE(scatter_along_scan(scan_of(random, 2, 1, 2e-3, 0)).empty()) << "one hit per point";
  EXPECT_TRUE(scatter_along_scan({}).empty());
}

// The scatter is pooled over all points: from the two hits of one point alone, some points would get almost no standard
// deviation.
TEST(WithScatter, GivesNodesTrueStandardDeviations) {
  std::mt19937 random(3);
  for (const std::size_t hits : {2U, 3U, 5U}) {
    constexpr int kScans = 300;
    double squares = 0, nodes = 0;
    for (int i = 0; i < kScans; ++i) {
      const auto modes = scan_of(random, 3, hits, 2e-3, 0.01);
      const auto scatter = scatter_along_scan(modes);
      ASSERT_EQ(scatter.size(), modes.size());
      for (int m = 0; m < 3; ++m) {
        const ScanShape shape = with_scatter(modes[static_cast<std::size_t>(m)], scatter[static_cast<std::size_t>(m)]);
        for (const Node& node : find_nodes(shape)) {
          // One step of Newton from the node found: the exact node is within 1e-4 of it.
          const double x = node.position_m, step = 1e-5;
          const double slope = (shape_at(m + 1, x + step) - shape_at(m + 1, x - step)) / (2 * step);
          squares += std::pow(shape_at(m + 1, x) / slope / node.std_m, 2);
          ++nodes;
        }
      }
    }
    const double rms = std::sqrt(squares / nodes);
    EXPECT_GT(rms, 0.8) << hits << " hits";
    EXPECT_LT(rms, 1.2) << hits << " hits";
  }
}

TEST(WithScatter, KeepsTheStandardDeviationOfAPointWithoutHits) {
  std::mt19937 random(4);
  auto modes = scan_of(random, 2, 2, 2e-3, 0);
  modes[0].hits[5].clear();
  const auto scatter = scatter_along_scan(modes);
  ASSERT_EQ(scatter.size(), modes.size());
  const ScanShape shape = with_scatter(modes[0], scatter[0]);
  EXPECT_EQ(shape.std[5], modes[0].shape.std[5]);
  EXPECT_GT(shape.std[4], 5 * modes[0].shape.std[4]);
}

}  // namespace percuss::identify::scan_scatter_test
