#include "identify/shapes/nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/roots.hpp"
#include "core/units.hpp"
#include "synth/random_stream.hpp"
#include "synth/structure.hpp"

namespace percuss::identify::nodes_test {

constexpr double kRounding = 1e-9;  // of a least-squares fit in double precision, m

ScanShape scan_of(double start_m, double step_m, int count, const auto& shape, double std) {
  ScanShape scan;
  for (int i = 0; i < count; ++i) {
    scan.position_m.push_back(start_m + i * step_m);
    scan.amplitude.push_back(shape(scan.position_m.back()));
    scan.std.push_back(std);
  }
  return scan;
}

ScanShape with_noise(ScanShape scan, std::uint64_t seed) {
  std::vector<double> noise(scan.amplitude.size());
  synth::RandomStream({seed}).add_normal(1, noise);
  for (std::size_t i = 0; i < noise.size(); ++i) scan.amplitude[i] += noise[i] * scan.std[i];
  return scan;
}

TEST(FindNodes, FindsTheRootOfAStraightLine) {
  const auto nodes = find_nodes(scan_of(
      0.1, 0.01, 9, [](double x) { return 3 * (0.1437 - x); }, 1e-3));
  ASSERT_EQ(nodes.size(), 1U);
  EXPECT_LE(std::abs(nodes[0].position_m - 0.1437), kRounding);
  EXPECT_EQ(nodes[0].degree, 1);
}

TEST(FindNodes, FindsTheRootOfACubicThatALineMisses) {
  const auto cubic = [](double x) { return (0.1437 - x) * (1 + 8 * x) * (0.9 - x); };
  const auto nodes = find_nodes(scan_of(0.08, 0.01, 15, cubic, 1e-6));
  ASSERT_EQ(nodes.size(), 1U);
  EXPECT_LE(std::abs(nodes[0].position_m - 0.1437), kRounding);
  EXPECT_EQ(nodes[0].degree, 3);
}

TEST(FindNodes, FindsEveryNodeOfAShape) {
  const auto nodes = find_nodes(scan_of(
      0, 0.01, 85, [](double x) { return synth::free_beam_shape(3, x / 0.84); }, 1e-4));
  ASSERT_EQ(nodes.size(), 4U);
  for (const Node& node : nodes) {
    EXPECT_LE(std::abs(synth::free_beam_shape(3, node.position_m / 0.84)), 1e-3) << "of the amplitude 1 at a tip";
  }
  EXPECT_NEAR(nodes[0].position_m + nodes[3].position_m, 0.84, 1e-4) << "a free beam is symmetric";
}

TEST(FindNodes, FindsNoneWhereTheShapeKeepsItsSign) {
  EXPECT_TRUE(find_nodes(scan_of(
                             0, 0.01, 20, [](double x) { return 1 + x; }, 1e-3))
                  .empty());
  EXPECT_TRUE(find_nodes({}).empty());
  EXPECT_TRUE(find_nodes(scan_of(
                             0, 0.01, 1, [](double) { return 1.0; }, 1e-3))
                  .empty());
}

TEST(FindNodes, FindsOneNodeInNoiseAroundZero) {
  // Slope of one standard deviation per step: the points next to the node change sign at random.
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto scan = scan_of(
        0, 0.01, 25, [](double x) { return 0.117 - x; }, 0.01);
    EXPECT_EQ(find_nodes(with_noise(scan, seed)).size(), 1U) << seed;
  }
}

TEST(FindNodes, StatesTrueStandardDeviations) {
  // The fractions within one and three standard deviations. The stated standard deviation includes the distance to the
  // root of the next degree, so these fractions may be larger than expected.
  constexpr int kScans = 2000;
  const auto shape = [](double x) { return synth::free_beam_shape(1, x / 0.84); };
  int one = 0, three = 0;
  double squares = 0;
  const double exact = find_nodes(scan_of(3 * kInch_m, 0.25 * kInch_m, 25, shape, 1e-9)).at(0).position_m;
  for (int i = 0; i < kScans; ++i) {
    const auto scan = with_noise(scan_of(3 * kInch_m, 0.25 * kInch_m, 25, shape, 0.01), static_cast<std::uint64_t>(i));
    const auto nodes = find_nodes(scan);
    ASSERT_EQ(nodes.size(), 1U);
    const double off = std::abs(nodes[0].position_m - exact) / nodes[0].std_m;
    squares += off * off;
    one += off <= 1 ? 1 : 0;
    three += off <= 3 ? 1 : 0;
  }
  EXPECT_GE(one, 0.68 * kScans - 4 * std::sqrt(0.22 * kScans)) << "four standard deviations of a binomial count";
  EXPECT_GE(three, 0.99 * kScans);
  EXPECT_GE(std::sqrt(squares / kScans), 0.4) << "not exaggerated either";
}

TEST(FindNodes, IncludesScatterBeyondTheStatedStandardDeviations) {
  // Hits that land 1 mm off: ten times the stated standard deviation.
  const auto line = [](double x) { return 0.117 - x; };
  const auto exact = find_nodes(scan_of(0, 0.01, 25, line, 1e-4)).at(0);
  auto scan = with_noise(scan_of(0, 0.01, 25, line, 1e-3), 7);
  for (double& std : scan.std) std = 1e-4;
  const auto node = find_nodes(scan).at(0);
  EXPECT_GE(node.std_m, 5 * exact.std_m);
  EXPECT_LE(std::abs(node.position_m - 0.117), 4 * node.std_m);
}

// Zeros of free_beam_shape(mode, x/length) in m, by the synthesiser's own shape.
std::vector<double> beam_nodes_m(int mode, double length_m) {
  std::vector<double> nodes;
  const auto shape = [&](double x) { return synth::free_beam_shape(mode, x / length_m); };
  constexpr int kParts = 1001;
  for (int i = 0; i < kParts; ++i) {
    const double low_m = length_m * i / kParts, high_m = length_m * (i + 1) / kParts;
    if (shape(low_m) * shape(high_m) < 0) nodes.push_back(bracketed_root(shape, low_m, high_m));
  }
  return nodes;
}

struct Comparison {
  int nodes = 0;
  double z2 = 0, most_z = 0, most_off_m = 0;
  void add(double off_m, double std_m) {
    ++nodes;
    z2 += std::pow(off_m / std_m, 2);
    most_z = std::max(most_z, std::abs(off_m / std_m));
    most_off_m = std::max(most_off_m, std::abs(off_m));
  }
  double rms_z() const { return std::sqrt(z2 / nodes); }
};

// The nodes of bending 1 to 4 of a bat 33 in long in one scan per mode and seed.
Comparison compare_nodes(double start_in, double step_in, int count, double std, int seeds) {
  constexpr double kLength_m = 33 * kInch_m;
  Comparison out;
  for (int mode = 1; mode <= 4; ++mode) {
    const auto truth_m = beam_nodes_m(mode, kLength_m);
    EXPECT_EQ(truth_m.size(), static_cast<std::size_t>(mode) + 1);
    const auto exact = scan_of(
        start_in * kInch_m, step_in * kInch_m, count,
        [&](double x) { return synth::free_beam_shape(mode, x / kLength_m); }, std);
    for (int seed = 0; seed < seeds; ++seed) {
      for (const Node& node : find_nodes(with_noise(exact, static_cast<std::uint64_t>(100 * mode + seed)))) {
        const auto nearest = *std::min_element(truth_m.begin(), truth_m.end(), [&](double a, double b) {
          return std::abs(a - node.position_m) < std::abs(b - node.position_m);
        });
        out.add(node.position_m - nearest, node.std_m);
      }
    }
  }
  return out;
}

// A single polynomial over the whole bat would put nodes 1 in off: its degree is too low for all extremes of the
// shape.
TEST(FindNodes, FollowsShapesWithMoreNodesThanAPolynomialOfTheirWholeLength) {
  const struct {
    double step_in;
    int count;
    double most_in;  // largest error, at mode 4; with a step of 2 in, its half wave has four points
  } scans[] = {{1, 32, 0.05}, {1.5, 21, 0.05}, {2, 16, 0.2}};
  for (const auto& scan : scans) {
    const Comparison exact = compare_nodes(1, scan.step_in, scan.count, 1e-6, 1);
    EXPECT_EQ(exact.nodes, 14) << scan.step_in;
    EXPECT_LE(exact.most_off_m, scan.most_in * kInch_m) << scan.step_in;
    EXPECT_LE(exact.most_z, 2) << scan.step_in;
    const Comparison noisy = compare_nodes(1, scan.step_in, scan.count, 3e-3, 40);
    EXPECT_LE(noisy.rms_z(), 1.1) << scan.step_in;
    EXPECT_GE(noisy.rms_z(), 0.3) << scan.step_in << ": not exaggerated either";
    EXPECT_LE(noisy.most_z, 4) << scan.step_in;
  }
}

TEST(FindNodes, StatesTrueStandardDeviationsAtAnEndOfTheBat) {
  const Comparison handle = compare_nodes(20, 1, 13, 3e-3, 40), barrel = compare_nodes(3, 0.5, 13, 3e-3, 40);
  for (const Comparison& scan : {handle, barrel}) {
    EXPECT_LE(scan.rms_z(), 1.1);
    EXPECT_GE(scan.rms_z(), 0.3) << "not exaggerated either";
    EXPECT_LE(scan.most_off_m, 0.05 * kInch_m);
  }
}

TEST(FindNodes, DoesNotDependOnSignOrUnits) {
  auto scan = with_noise(scan_of(
                             0.08, 0.01, 15, [](double x) { return synth::free_beam_shape(2, x / 0.84); }, 1e-3),
                         1);
  const Node node = find_nodes(scan).at(0);
  for (double& a : scan.amplitude) a *= -7;
  for (double& s : scan.std) s *= 7;
  const Node other = find_nodes(scan).at(0);
  EXPECT_LE(std::abs(other.position_m - node.position_m), kRounding);
  EXPECT_LE(std::abs(other.std_m / node.std_m - 1), 1e-6) << "rounding of a standard deviation";
}

TEST(MinimumOfPeak, IsTheBottomOfTheV) {
  const auto bottom = [](double node, double start) {
    std::vector<double> x, peak;
    for (int i = 0; i < 25; ++i) {
      x.push_back(start + 0.25 * i);
      peak.push_back(std::abs(x.back() - node));
    }
    return minimum_of_peak(x, peak, 0.125);
  };
  EXPECT_EQ(bottom(6.0, 3), 6.0);
  EXPECT_EQ(bottom(6.1, 3), 6.125);
  EXPECT_EQ(bottom(6.05, 3), 6.0);
  EXPECT_EQ(bottom(3.12, 3), 3.125) << "between the first two";
  EXPECT_EQ(bottom(8.9, 3), 8.875) << "between the last two";
  EXPECT_EQ(bottom(2.5, 3), std::nullopt) << "before the scan";
  EXPECT_EQ(bottom(9.4, 3), std::nullopt) << "behind it";
  EXPECT_EQ(minimum_of_peak(std::vector{1.0, 2.0}, std::vector{1.0, 1.0}, 0.1), std::nullopt);
}

TEST(DropWideNodes, KeepsNodesBetterKnownThanAnywhereInTheScan) {
  const ScanShape shape{.position_m = {0, 0.1, 0.2}, .amplitude = {1, 0.1, -1}, .std = {0.01, 0.01, 0.01}};
  std::vector<Node> nodes{{.position_m = 0.1, .std_m = 0.057}, {.position_m = 0.15, .std_m = 0.058}};
  drop_wide_nodes(nodes, shape);  // 0.2 m over √12 is 0.0577 m
  ASSERT_EQ(nodes.size(), 1U);
  EXPECT_EQ(nodes[0].position_m, 0.1);
}

TEST(ReasonWithoutNode, TellsTheSignsApart) {
  const auto reason = [](const std::vector<double>& amplitude) {
    return reason_without_node({.position_m = {0, 0.1, 0.2}, .amplitude = amplitude, .std = {0.1, 0.1, 0.1}});
  };
  EXPECT_EQ(reason({1, 0.5, 0.2}), NoNode::same_sign);
  EXPECT_EQ(reason({1, 0.2, -0.2}), NoNode::uncertain);
  EXPECT_EQ(reason({1, 0.2, -1}), NoNode::wide);
  EXPECT_EQ(name_of(NoNode::same_sign), "same_sign");
}

}  // namespace percuss::identify::nodes_test
