#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "acquire/formats/hdf5/write_hdf5.hpp"
#include "support/json.hpp"
#include "support/json_schema.hpp"
#include "support/modal_frfs.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"
#include "synth/synthesise.hpp"

namespace percuss::nodes_command_test {

using nlohmann::json;
using test::lines_of;
using test::run_percuss;
using testing::AllOf;
using testing::HasSubstr;

// A beam struck every half inch from 6 to 9 in.
synth::SynthSpec beam() { return test::roving_beam_spec(6, 0.5, 7); }

class NodesCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::ScratchFolder>();
    const acquire::Record scan = synth::synthesise(beam()).record;
    acquire::write_hdf5(file("scan.h5"), scan, true);
    for (int point = 0; point < 7; ++point) {
      acquire::Record one = acquire::select_rows(scan, [&](const acquire::RowInfo& row) { return row.point == point; });
      one.rows[0].point = 0;
      acquire::write_hdf5(file("point" + std::to_string(point) + ".h5"), one, true);
    }
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::string file(const std::string& name) { return folder_->file(name); }
  static test::ProcessOutcome nodes(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "nodes");
    return run_percuss(arguments);
  }
  static double first_node_in(const json& document) {
    return document["modes"].at(0)["nodes"].at(0)["position_in"].get<double>();
  }
  inline static std::unique_ptr<test::ScratchFolder> folder_;
};

constexpr double kNodeTolerance_in = 0.01;  // for 0.1 % of noise on a straight shape

TEST_F(NodesCommand, WritesATableOfNodes) {
  ASSERT_EQ(nodes({file("scan.h5"), "--positions", "6:0.5:9in", "-o", file("nodes.csv")}).code, 0);
  const auto lines = lines_of(test::bytes_of(file("nodes.csv")));
  ASSERT_GE(lines.size(), 2U);
  EXPECT_EQ(
      lines[0],
      "mode,order,frequency_hz,frequency_std_hz,damping_ratio,damping_ratio_std,node_m,node_std_m,minimum_m,family");
  EXPECT_THAT(lines[1], HasSubstr(",0.19"));  // 7.5 in are 0.1905 m
}

TEST_F(NodesCommand, PrintsADocumentThatFitsItsSchema) {
  const auto outcome = nodes({file("scan.h5"), "--positions", "6:0.5:9in", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("nodes")), testing::IsEmpty());
  EXPECT_NEAR(first_node_in(document), 7.5, kNodeTolerance_in);
  EXPECT_EQ(document["modes"][0]["minimum_in"], 7.5);
  EXPECT_EQ(document["positions"]["count"], 7);
  EXPECT_EQ(document["modes"][0]["shape"].size(), 7U);
}

// The node at 7.5 in lies beyond the positions.
TEST_F(NodesCommand, SaysWhyAModeHasNoNode) {
  const std::vector<std::string> arguments{file("point0.h5"), file("point1.h5"), file("point2.h5"), "--positions",
                                           "6:0.5:7in"};
  const auto text = nodes(arguments);
  ASSERT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("Hz: the shape keeps its sign at all positions"));
  std::vector<std::string> as_json = arguments;
  as_json.emplace_back("--json");
  const json document = test::parse_json(nodes(as_json).out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("nodes")), testing::IsEmpty());
  EXPECT_TRUE(document["modes"].at(0)["nodes"].empty());
  EXPECT_EQ(document["modes"].at(0)["no_node"], "same_sign");
}

TEST_F(NodesCommand, ReadsInchesUnlessAUnitFollows) {
  for (const char* positions : {"6:0.5:9", "+6:0.5:9in", "0.1524:0.0127:0.2286m", "152.4:12.7:228.6mm"}) {
    const auto outcome = nodes({file("scan.h5"), "--positions", positions, "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NEAR(first_node_in(test::parse_json(outcome.out)), 7.5, kNodeTolerance_in) << positions;
  }
}

TEST_F(NodesCommand, CountsModesFromOneInItsTable) {
  const std::string text = nodes({file("scan.h5"), "--quiet"}).out;
  EXPECT_THAT(text, testing::ContainsRegex("\n +1  [a-z]"));
  EXPECT_THAT(text, testing::Not(testing::ContainsRegex("\n +0  [a-z]")));
}

TEST_F(NodesCommand, TakesAListOrTheGeometryOfTheRecord) {
  for (const std::vector<std::string>& positions :
       std::vector<std::vector<std::string>>{{"--positions", "6,6.5,7,7.5,8,8.5,9in"}, {}}) {
    std::vector<std::string> arguments{file("scan.h5"), "--json"};
    arguments.insert(arguments.end(), positions.begin(), positions.end());
    const auto outcome = nodes(arguments);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json document = test::parse_json(outcome.out);
    EXPECT_THAT(test::schema_violations(document, test::schema_named("nodes")), testing::IsEmpty());
    EXPECT_NEAR(first_node_in(document), 7.5, kNodeTolerance_in);
    EXPECT_EQ(document["positions"]["listed_m"].size(), 7U);
  }
  const auto without = nodes({file("point0.h5"), file("point1.h5")});
  EXPECT_EQ(without.code, 3);
  EXPECT_THAT(without.err, HasSubstr("--positions"));
  const auto wrong = nodes({file("scan.h5"), "--positions", "6,x,7"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("neither a range nor a list"));
}

TEST_F(NodesCommand, TakesSeveralFilesAsPointsInTheirOrder) {
  std::vector<std::string> arguments{"--positions", "6:0.5:9", "--json"};
  for (int point = 0; point < 7; ++point) arguments.push_back(file("point" + std::to_string(point) + ".h5"));
  const auto outcome = nodes(arguments);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(first_node_in(test::parse_json(outcome.out)), 7.5, kNodeTolerance_in);
}

// A shell gives "s10 s4 s5 …" for the pattern s*; s10 is the last point.
TEST_F(NodesCommand, OrdersTheFilesOfAnUnquotedPatternByTheirNumbers) {
  std::vector<std::string> paths;
  for (int point = 0; point < 7; ++point) {
    paths.push_back(file("s" + std::to_string(point + 4) + ".h5"));
    std::filesystem::copy_file(file("point" + std::to_string(point) + ".h5"), paths.back());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> arguments{"--positions", "6:0.5:9", "--json"};
  arguments.insert(arguments.end(), paths.begin(), paths.end());
  const auto outcome = nodes(arguments);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(first_node_in(test::parse_json(outcome.out)), 7.5, kNodeTolerance_in);
  EXPECT_THAT(outcome.out, HasSubstr("s9.h5 before s10.h5"));
  std::swap(arguments[3], arguments[4]);  // neither order: the user's choice
  EXPECT_THAT(nodes(arguments).out, testing::Not(HasSubstr("s9.h5 before s10.h5")));
}

// Two files per position: by their names, or by equal positions.
TEST_F(NodesCommand, TakesSeveralFilesPerPosition) {
  const std::string listed = "6,6,6.5,6.5,7,7,7.5,7.5,8,8,8.5,8.5,9,9in";
  const auto scan_of = [](const std::string& folder, const std::vector<std::string>& options) {
    std::vector<std::string> arguments{folder, "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return nodes(arguments);
  };
  synth::SynthSpec two_hits = beam();
  two_hits.hits = 2;
  acquire::Record scan = synth::synthesise(two_hits).record;
  scan.geometry.clear();
  constexpr int kFiles = 14;
  ASSERT_EQ(scan.rows.size(), static_cast<std::size_t>(kFiles));
  for (int i = 0; i < kFiles; ++i) scan.rows[static_cast<std::size_t>(i)].point = i;
  const auto make = [&](const std::string& folder, const auto& name) {
    std::filesystem::create_directory(folder);
    for (int i = 0; i < kFiles; ++i) {
      acquire::Record one = acquire::select_rows(scan, [&](const acquire::RowInfo& row) { return row.point == i; });
      one.rows[0].point = 0;
      acquire::write_hdf5((std::filesystem::path(folder) / name(i)).string(), one, true);
    }
    return folder;
  };
  const std::string named = make(
      file("named"), [](int i) { return "in" + std::to_string(12 + i / 2) + "_" + std::to_string(i % 2 + 1) + ".h5"; });
  const std::string counted = make(file("counted"), [](int i) { return "blow" + std::to_string(i + 1) + ".h5"; });
  const auto by_names = scan_of(named, {"--positions", "6:0.5:9in"});
  ASSERT_EQ(by_names.code, 0) << by_names.err;
  EXPECT_THAT(by_names.out, HasSubstr("the 14 files are hits of 7 points, by their names: in12_1.h5, in12_2.h5"));
  EXPECT_NEAR(first_node_in(test::parse_json(by_names.out)), 7.5, kNodeTolerance_in);
  // Positions of a range and of a list may differ in their last digits.
  const auto residues_of = [](const std::string& document) {
    std::vector<double> residues;
    const json shape = test::parse_json(document)["modes"].at(0)["shape"];
    for (const json& at : shape) residues.push_back(at["residue"].get<double>());
    return residues;
  };
  const std::vector<double> expected = residues_of(by_names.out);
  EXPECT_EQ(expected.size(), 7U);
  for (const std::vector<std::string>& options :
       std::vector<std::vector<std::string>>{{"--positions", listed},
                                             {"--positions", listed, "--files", "points"},
                                             {"--positions", listed, "--files", "hits"},
                                             {"--positions", "6:0.5:9in", "--files", "hits"}}) {
    for (const std::string& folder : {named, counted}) {
      const auto outcome = scan_of(folder, options);
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      EXPECT_EQ(residues_of(outcome.out), expected) << folder << " " << options.back();
    }
  }
  const auto refused = scan_of(counted, {"--positions", "6:0.5:9in"});
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("14 points"), HasSubstr("repeat the position of further hits")));
  const auto points = scan_of(named, {"--positions", "6:0.5:9in", "--files", "points"});
  EXPECT_EQ(points.code, 3) << "each file is a point by the user's word";
}

// All hits in one continuous record, two at each position.
TEST_F(NodesCommand, TakesTheHitsOfOneContinuousRecord) {
  synth::SynthSpec spec = beam();
  spec.hits = 2;
  const acquire::Record rows = synth::synthesise(spec).record;
  std::vector<double> force_N, accel_mps2;
  for (std::size_t row = 0; row < rows.rows.size(); ++row) {
    std::vector<double> x(rows.rows[row].samples);
    rows.read_force_N(row, 0, x);
    force_N.insert(force_N.end(), x.begin(), x.end());
    rows.read_accel_mps2(row, 0, 0, x);
    accel_mps2.insert(accel_mps2.end(), x.begin(), x.end());
  }
  acquire::write_hdf5(file("long.h5"), acquire::record_in_memory(rows.fs_Hz, {force_N}, {{accel_mps2}}), true);
  for (const std::string positions : {"6,6,6.5,6.5,7,7,7.5,7.5,8,8,8.5,8.5,9,9in", "6:0.5:9in"}) {
    const auto outcome = nodes({file("long.h5"), "--positions", positions, "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NEAR(first_node_in(test::parse_json(outcome.out)), 7.5, kNodeTolerance_in) << positions;
    EXPECT_THAT(outcome.out, HasSubstr("the 14 hits of the record have the positions of the scan, in their order"));
  }
  const auto refused = nodes({file("long.h5"), "--positions", "6,6.5,7,7.5,8in"});
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, HasSubstr("14 rows of hits for 5 positions"));
}

TEST_F(NodesCommand, LeavesOutFilesOfAFolderThatAreNoRecords) {
  const std::filesystem::path folder = file("session");
  std::filesystem::create_directory(folder);
  for (int point = 0; point < 7; ++point) {
    const std::string name = "point" + std::to_string(point) + ".h5";
    std::filesystem::copy_file(file(name), folder / name);
  }
  test::write_bytes((folder / "README.txt").string(), "The bat was hung by two cords.\n");
  const auto outcome = nodes({folder.string(), "--positions", "6:0.5:9", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(first_node_in(test::parse_json(outcome.out)), 7.5, kNodeTolerance_in);
  EXPECT_THAT(outcome.out, HasSubstr("left out, because it holds no numbers: README.txt"));
  const auto named = nodes({file("point0.h5"), (folder / "README.txt").string(), "--positions", "6:0.5:9"});
  EXPECT_EQ(named.code, 3) << "a file that is named must be a record";
}

TEST_F(NodesCommand, WorksFromFrfs) {
  ASSERT_EQ(run_percuss({"frf", file("scan.h5"), "--band", "60:1000", "-o", file("frf.csv")}).code, 0);
  const auto outcome = nodes({file("frf.csv"), "--positions", "6:0.5:9", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(first_node_in(test::parse_json(outcome.out)), 7.5, kNodeTolerance_in);
}

TEST_F(NodesCommand, PrintsATable) {
  const auto outcome = nodes({file("scan.h5"), "--positions", "6:0.5:9", "-o", file("nodes.json")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("7 positions, 6 to 9 in"), HasSubstr("7.500 in"), HasSubstr("±")));
  EXPECT_EQ(test::parse_json(test::bytes_of(file("nodes.json")))["schema"], "percuss/nodes/1");
}

TEST_F(NodesCommand, RejectsInvalidPositions) {
  for (const char* positions : {"", "6", "6:9", "6:0.5:9furlongs", "6:0.5:9N", "6:0:9", "9:0.5:6", "6:0.4:9", "6;0.5;9",
                                "nan:0.5:9", "6:1e-9:9"}) {
    const auto outcome = nodes({file("scan.h5"), "--positions", positions});
    EXPECT_EQ(outcome.code, 2) << positions;
    EXPECT_EQ(lines_of(outcome.err).size(), 1U);
    EXPECT_THAT(outcome.err, HasSubstr("positions")) << positions;
  }
}

// Numbers in m or mm, as Python's lists may be, would give nodes wrong by a factor of 39 or 25, without a message.
TEST_F(NodesCommand, AsksForTheUnitOfPositionsThatAreHardlyInches) {
  for (const char* positions : {"0.1524:0.0127:0.2286", "0.15,0.17,0.19", "152.4:12.7:228.6", "152,165,178"}) {
    const auto outcome = nodes({file("scan.h5"), "--positions", positions});
    EXPECT_EQ(outcome.code, 2) << positions;
    EXPECT_THAT(outcome.err, HasSubstr("without a unit they are inches")) << positions;
    EXPECT_THAT(outcome.err, HasSubstr("state the unit")) << positions;
  }
}

TEST_F(NodesCommand, RejectsAScanOfAnotherLength) {
  const auto outcome = nodes({file("scan.h5"), "--positions", "3:0.25:9"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("7 points"), HasSubstr("25 positions"), HasSubstr("scan.h5")));
}

}  // namespace percuss::nodes_command_test
