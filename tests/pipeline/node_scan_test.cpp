#include "pipeline/node_scan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "support/input_error.hpp"
#include "synth/read_spec.hpp"
#include "synth/structure.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::node_scan_test {

constexpr double kNodeError_in = 0.02;  // positions by hand are accurate to a few hundredths of an inch
constexpr double kDeviations = 3;
// Half a step: the resolution of the rule in [8] of docs/theory/sources.md, which places the node where the peak is
// smallest.
constexpr double kMinimumResolution_in = 0.125;

const ScanPositions kScan{.start_m = 3 * kInch_m, .step_m = 0.25 * kInch_m, .count = 25};

synth::SynthSpec scan_spec(const char* preset, std::uint64_t seed) {
  synth::SynthSpec spec = synth::synth_preset(preset);
  spec.points.clear();
  for (std::size_t i = 0; i < kScan.count; ++i)
    spec.points.push_back({.position_m = kScan.at_m(i), .angle_rad = 20 * kTwoPi / 360});
  spec.hits = 1;
  spec.seed = seed;
  spec.noise = {.force = 0.01, .accel = 0.01};
  return spec;
}

NodeScan scan_of(const synth::SynthSpec& spec) {
  const Analysis analysis(synth::synthesise(spec).record, {.band_Hz = std::pair{60.0, 3200.0}});
  return scan_nodes(analysis, kScan, kMinimumResolution_in * kInch_m);
}

// Zeros of the mode's shape within the scan, by bisection of its sign changes.
std::vector<double> exact_nodes_m(const synth::SynthSpec& spec, const synth::SynthMode& mode) {
  const auto shape = [&](double x) { return synth::mode_shape_per_sqrt_kg(spec.structure, mode, x, mode.angle_rad); };
  std::vector<double> nodes;
  for (std::size_t i = 0; i + 1 < kScan.count; ++i) {
    double low = kScan.at_m(i);
    double high = kScan.at_m(i + 1);
    if (shape(low) * shape(high) >= 0) continue;
    for (int step = 0; step < 60; ++step) (shape(low) * shape((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
    nodes.push_back(low);
  }
  return nodes;
}

void expect_nodes(const char* preset, std::uint64_t seed) {
  const synth::SynthSpec spec = scan_spec(preset, seed);
  const NodeScan scan = scan_of(spec);
  std::size_t bending = 0;
  for (const synth::SynthMode& mode : spec.modes) {
    if (mode.type != synth::SynthModeType::bending) continue;
    SCOPED_TRACE(testing::Message() << preset << ", seed " << seed << ", " << mode.freq_Hz << " Hz");
    const auto exact = exact_nodes_m(spec, mode);
    ASSERT_EQ(exact.size(), 1U);
    ASSERT_LT(bending, scan.modes.size());
    const ModeAlongScan& along = scan.modes[bending++];
    ASSERT_EQ(along.nodes.size(), 1U);
    const double off_in = std::abs(along.nodes[0].position_m - exact[0]) / kInch_m;
    EXPECT_LE(off_in, kNodeError_in) << "± " << along.nodes[0].std_m / kInch_m;
    EXPECT_LE(off_in, kDeviations * along.nodes[0].std_m / kInch_m);
    ASSERT_TRUE(along.minimum_m);
    EXPECT_LE(std::abs(*along.minimum_m - exact[0]) / kInch_m, kMinimumResolution_in);
  }
  EXPECT_EQ(bending, scan.modes.size());
}

TEST(NodeScan, FindsTheNodesOfAWoodBat) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) expect_nodes("wood-bat", seed);
}

TEST(NodeScan, FindsTheNodesOfAnAluminiumBat) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) expect_nodes("aluminium-bat", seed);
}

TEST(NodeScan, IsExactWithoutNoise) {
  synth::SynthSpec spec = scan_spec("wood-bat", 0);
  spec.noise = {};
  const NodeScan scan = scan_of(spec);
  ASSERT_EQ(scan.modes.size(), 3U);
  constexpr double kModel_in = 1e-4;  // error of a polynomial of degree five that fits the beam's shape over ±2 in
  for (std::size_t m = 0; m < 3; ++m) {
    const double off_m = scan.modes[m].nodes.at(0).position_m - exact_nodes_m(spec, spec.modes[m]).at(0);
    EXPECT_LE(std::abs(off_m) / kInch_m, kModel_in) << m;
  }
}

TEST(NodeScan, OmitsAPositionWithoutAUsableHit) {
  synth::SynthSpec spec = scan_spec("wood-bat", 3);
  spec.faults = {{.hit = 17, .kind = synth::SynthFaultKind::missing}};
  const NodeScan scan = scan_of(spec);
  ASSERT_EQ(scan.modes.size(), 3U);
  EXPECT_EQ(scan.modes[0].shape.position_m.size(), kScan.count - 1);
  const double off_m = scan.modes[0].nodes.at(0).position_m - exact_nodes_m(spec, spec.modes[0]).at(0);
  EXPECT_LE(std::abs(off_m) / kInch_m, kNodeError_in);
  ASSERT_EQ(scan.warnings.size(), 2U);
  EXPECT_THAT(scan.warnings[0].message, testing::HasSubstr("7.25 in"));
  EXPECT_EQ(scan.warnings[1].code, "one_hit_each");
}

std::vector<std::string> codes_of(const NodeScan& scan) {
  std::vector<std::string> codes;
  for (const Warning& warning : scan.warnings) codes.push_back(warning.code);
  return codes;
}

TEST(NodeScan, SaysThatOneHitPerPositionShowsNoErrorOfItsPlace) {
  synth::SynthSpec spec = scan_spec("wood-bat", 0);
  EXPECT_THAT(codes_of(scan_of(spec)), testing::ElementsAre("one_hit_each"));
  spec.hits = 2;
  EXPECT_THAT(codes_of(scan_of(spec)), testing::IsEmpty());
}

TEST(NodeScan, NamesExchangedPositions) {
  acquire::Record record = synth::synthesise(scan_spec("wood-bat", 0)).record;
  record.geometry.clear();
  for (acquire::RowInfo& row : record.rows) {
    if (row.point == 8 || row.point == 14) row.point = 22 - row.point;
  }
  const Analysis analysis(std::move(record), {.band_Hz = std::pair{60.0, 3200.0}});
  const NodeScan scan = scan_nodes(analysis, kScan, kMinimumResolution_in * kInch_m);
  ASSERT_THAT(codes_of(scan), testing::ElementsAre("one_hit_each", "misplaced_hits"));
  EXPECT_THAT(scan.warnings[1].message,
              testing::ContainsRegex("at 5 in by [0-9]+ standard deviations, as if at 6.5 in"));
  EXPECT_THAT(scan.warnings[1].message,
              testing::ContainsRegex("at 6.5 in by [0-9]+ standard deviations, as if at 5 in"));
}

TEST(NodeScan, NamesAHitAtAnotherPosition) {
  synth::SynthSpec spec = scan_spec("wood-bat", 0);
  spec.hits = 2;
  acquire::Record record = synth::synthesise(spec).record;
  record.geometry.clear();
  std::swap(record.rows[16].point, record.rows[29].point);  // one hit of 5 and one of 6.5 in
  const Analysis analysis(std::move(record), {.band_Hz = std::pair{60.0, 3200.0}});
  const NodeScan scan = scan_nodes(analysis, kScan, kMinimumResolution_in * kInch_m);
  ASSERT_THAT(codes_of(scan), testing::ElementsAre("misplaced_hits"));
  EXPECT_THAT(scan.warnings[0].message,
              testing::AllOf(testing::HasSubstr("hit 30 at 5 in"), testing::HasSubstr("hit 17 at 6.5 in")));
}

TEST(AsScan, AssignsRowsInOrderWhenPointsAreNotStated) {
  acquire::Record record = synth::synthesise(scan_spec("wood-bat", 0)).record;
  for (acquire::RowInfo& row : record.rows) row.point = 0;
  const acquire::Record scan = as_scan(record, kScan);
  for (std::size_t row = 0; row < scan.rows.size(); ++row) EXPECT_EQ(scan.rows[row].point, static_cast<int>(row));
  EXPECT_EQ(scan.notes.size(), record.notes.size() + 1);
}

TEST(AsScan, MergesFilesOfEqualPositions) {
  synth::SynthSpec spec = scan_spec("wood-bat", 0);
  spec.points.resize(5);
  const acquire::Record files = synth::synthesise(spec).record;
  const ScanPositions positions = repeated_positions({0.1, 0.1, 0.3, 0.2, 0.2});
  EXPECT_THAT(positions.listed_m, testing::ElementsAre(0.1, 0.3, 0.2));
  EXPECT_EQ(positions.count, 3U);
  EXPECT_EQ(positions.stated(), 5U);
  const auto points_of = [](const acquire::Record& record) {
    std::vector<int> points;
    for (const acquire::RowInfo& row : record.rows) points.push_back(row.point);
    return points;
  };
  EXPECT_THAT(points_of(as_scan(files, positions, true)), testing::ElementsAre(0, 0, 1, 2, 2));
  // The points of one record must have different positions.
  EXPECT_THAT(test::input_error_of([&] { as_scan(files, positions); }),
              testing::HasSubstr("two points of the scan lie at 3.93701 in"));
  // Rows whose points are not stated.
  acquire::Record rows = files;
  for (acquire::RowInfo& row : rows.rows) row.point = 0;
  const acquire::Record scan = as_scan(rows, positions);
  EXPECT_THAT(points_of(scan), testing::ElementsAre(0, 0, 1, 2, 2));
  EXPECT_EQ(scan.notes.size(), rows.notes.size()) << "nothing is assumed";
  EXPECT_THAT(test::input_error_of([&] {
                as_scan(files, repeated_positions({0.1, 0.1, 0.2}), true);
              }),
              testing::HasSubstr("5 points and 5 rows of hits for 3 positions"));
}

TEST(AsScan, RefusesAnotherNumberOfPoints) {
  const acquire::Record record = synth::synthesise(scan_spec("wood-bat", 0)).record;
  ScanPositions positions = kScan;
  --positions.count;
  const std::string message = test::input_error_of([&] { as_scan(record, positions); });
  EXPECT_THAT(message, testing::HasSubstr("25 points"));
  EXPECT_THAT(message, testing::HasSubstr("24 positions"));
}

TEST(NodeScan, RefusesPositionsThatContradictTheGeometry) {
  const Analysis analysis(synth::synthesise(scan_spec("wood-bat", 0)).record, {.band_Hz = std::pair{60.0, 1500.0}});
  const ScanPositions millimetres{.start_m = 3e-3, .step_m = 0.25e-3, .count = 25};
  const std::string message =
      test::input_error_of([&] { scan_nodes(analysis, millimetres, kMinimumResolution_in * kInch_m); });
  EXPECT_THAT(message, testing::HasSubstr("differ by up to 5.764 in; the scan is 0.2362 in long by the positions, 6 in "
                                          "by the geometry"));
}

TEST(ScanPositions, RefuseTwoPointsAtOnePlace) {
  EXPECT_THAT(test::input_error_of([] {
                listed_positions({3 * kInch_m, 5 * kInch_m, 3 * kInch_m}, "3,5,3in");
              }),
              testing::HasSubstr("two points of the scan lie at 3 in"));
}

TEST(NodeScan, RefusesHitsAtOnePoint) {
  synth::SynthSpec spec = synth::synth_preset("wood-bat");
  spec.hits = 5;
  const ScanPositions five{.start_m = 5 * kInch_m, .step_m = kInch_m, .count = 5};
  acquire::Record record = synth::synthesise(spec).record;
  record.geometry.clear();
  const Analysis analysis(as_scan(std::move(record), five), {.band_Hz = std::pair{60.0, 1500.0}});
  const std::string message =
      test::input_error_of([&] { scan_nodes(analysis, five, kMinimumResolution_in * kInch_m, true); });
  EXPECT_THAT(message, testing::HasSubstr("the hits are at one point"));
}

}  // namespace percuss::pipeline::node_scan_test
