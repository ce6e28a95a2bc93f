#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>

#include "support/files/synthetic_files.hpp"
#include "support/json.hpp"
#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::analyze_command_test {

using nlohmann::json;
using test::run_percuss;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// All tests share small files: making them takes longer than analysing them.
class AnalyzeCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::ScratchFolder>();
    test::write_small_test(file("bat.h5"));
    test::write_small_test(file("bat.csv"));
    test::write_small_test(file("runs.h5"), R"("hits": 2, "runs": 2)");
    test::write_small_test(file("missing.h5"), R"("hits": 1, "faults": [{"hit": 0, "kind": "missing"}])");
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::string file(const std::string& name) { return folder_->file(name); }
  static test::ProcessOutcome analyze(std::vector<std::string> arguments, const test::ProcessOptions& options = {}) {
    arguments.insert(arguments.begin(), "analyze");
    return run_percuss(arguments, options);
  }
  static std::vector<std::string> violations_in(const json& document) {
    const json schema = test::schema_named("analysis");
    auto violations = test::schema_violations(document, schema);
    for (const json& run : document.value("runs", json::array())) {
      const auto more = test::schema_violations(run, schema);
      violations.insert(violations.end(), more.begin(), more.end());
    }
    return violations;
  }
  static json document_of(std::vector<std::string> arguments) {
    arguments.emplace_back("--json");
    const auto outcome = analyze(std::move(arguments));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    json document = test::parse_json(outcome.out);
    EXPECT_THAT(violations_in(document), IsEmpty());
    return document;
  }
  inline static std::unique_ptr<test::ScratchFolder> folder_;
};

TEST_F(AnalyzeCommand, PrintsHitsModesAndClassification) {
  const auto outcome = analyze({file("bat.h5")});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("3 hits × 2 accelerometers (0°, 90°)"), HasSubstr("bending 1"), HasSubstr("hoop 1")));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr(" Hz "), HasSubstr(" ± "), HasSubstr(" dB"), Not(HasSubstr("-0.0 dB"))));
}

TEST_F(AnalyzeCommand, PrintsOneJsonDocument) {
  const json document = document_of({file("bat.h5")});
  EXPECT_EQ(document["schema"], "percuss/analysis/1");
  EXPECT_EQ(document["inputs"][0]["path"], file("bat.h5"));
  EXPECT_EQ(document["inputs"][0]["bytes"], std::filesystem::file_size(file("bat.h5")));
  EXPECT_EQ(document["fs_hz"], 4096);
  ASSERT_EQ(document["hits"].size(), 3U);
  ASSERT_EQ(document["modes"].size(), 2U);
  EXPECT_NEAR(document["modes"][0]["frequency_hz"], 200, 0.01);
  EXPECT_NEAR(document["modes"][0]["damping_ratio"], 0.01, 1e-4);
  EXPECT_EQ(document["modes"][0]["family"], "bending");
  EXPECT_NEAR(document["modes"][1]["frequency_hz"], 700, 0.01);
  EXPECT_EQ(document["modes"][1]["family"], "hoop");
  EXPECT_EQ(document["modes"][1]["overlay"]["overlaid"], true);
  EXPECT_NEAR(document["modes"][1]["residues"][1]["re"], -0.8, 0.01);
  EXPECT_THAT(document["warnings"], IsEmpty());
}

TEST_F(AnalyzeCommand, ReadsTextAndStandardInputAlike) {
  json document = document_of({file("bat.csv"), "--angle", "0,90"});
  EXPECT_THAT(document["warnings"], IsEmpty());
  EXPECT_NEAR(document["modes"][1]["frequency_hz"], 700, 0.01);
  const auto outcome = analyze({"-", "--json", "--angle=0,90"}, {.input = file("bat.csv")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json piped = test::parse_json(outcome.out);
  EXPECT_EQ(piped["inputs"][0]["path"], "-");
  document["inputs"] = piped["inputs"];
  EXPECT_EQ(piped, document);
}

TEST_F(AnalyzeCommand, ReportsTheAssumedAngles) {
  const json document = document_of({file("bat.csv")});
  ASSERT_EQ(document["warnings"].size(), 1U);
  EXPECT_THAT(document["warnings"][0]["message"], AllOf(HasSubstr("0°"), HasSubstr("90°")));
  EXPECT_THAT(run_percuss({"analyze", file("bat.csv")}).out, HasSubstr("(--angle, --object)"));
}

TEST_F(AnalyzeCommand, PrintsEqualBytesForAnyNumberOfThreads) {
  const auto one = analyze({file("bat.h5"), "--json", "--threads", "1"});
  const auto three = analyze({file("bat.h5"), "--json", "--threads", "3"});
  EXPECT_EQ(one.code, 0);
  EXPECT_TRUE(one.out == three.out);
  EXPECT_TRUE(one.out == analyze({file("bat.h5"), "--json"}).out);
}

TEST_F(AnalyzeCommand, ComputesOnlyTheRequestedSections) {
  const json hits = document_of({file("bat.h5"), "--only", "hits", "--trace"});
  EXPECT_TRUE(hits.contains("hits"));
  EXPECT_FALSE(hits.contains("modes") || hits.contains("frf") || hits.contains("coherence"));
  for (const json& stage : hits["trace"]) {
    EXPECT_THAT(stage["stage"].get<std::string>(),
                Not(testing::AnyOf(HasSubstr("accel"), HasSubstr("frf"), HasSubstr("identify"))));
  }
  const json frf = document_of({file("bat.h5"), "--only", "frf,coherence"});
  EXPECT_FALSE(frf.contains("modes") || frf.contains("hits"));
  EXPECT_GT(frf["frf"]["lines"], 100);
  ASSERT_EQ(frf["coherence"].size(), 2U);
  EXPECT_GT(frf["coherence"][0]["mean"], 0.9);
}

TEST_F(AnalyzeCommand, PrintsOnlyTheTraceOnStandardError) {
  const auto outcome = analyze({file("bat.h5"), "--trace"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr(" calls "), HasSubstr(" s\n")));
  EXPECT_THAT(outcome.out, Not(HasSubstr(" calls ")));
}

TEST_F(AnalyzeCommand, FitsEachHitAloneOnRequest) {
  const json document = document_of({file("bat.h5"), "--per-hit"});
  ASSERT_EQ(document["modes_per_hit"].size(), 6U);
  for (const json& found : document["modes_per_hit"]) EXPECT_GT(found["peak_force_n"], 100);
  EXPECT_FALSE(document_of({file("bat.h5")}).contains("modes_per_hit"));
  EXPECT_THAT(analyze({file("bat.h5"), "--per-hit"}).out, HasSubstr("mode  hit"));
}

TEST_F(AnalyzeCommand, AddsTheStabilisationDiagramOnRequest) {
  const json document = document_of({file("bat.h5"), "--stabilisation", "--band", "500:1000"});
  EXPECT_EQ(document["stabilisation"]["band_hz"], (json{500, 1000}));
  std::size_t stable = 0;
  for (const json& pole : document["stabilisation"]["poles"]) {
    EXPECT_TRUE(pole["frequency_hz"] >= 500 && pole["frequency_hz"] <= 1000);
    if (pole["flag"] == "stable" && std::abs(pole["frequency_hz"].get<double>() - 700) < 0.1) ++stable;
  }
  EXPECT_GE(stable, 20U);  // of 39 orders
  EXPECT_FALSE(document_of({file("bat.h5")}).contains("stabilisation"));
  const auto without = analyze({file("bat.h5"), "--stabilisation"});
  EXPECT_EQ(without.code, 2);
  EXPECT_THAT(without.err, HasSubstr("(--json, --output)"));
}

TEST_F(AnalyzeCommand, KeepsToTheBand) {
  const json document = document_of({file("bat.h5"), "--band", "500:1000"});
  EXPECT_EQ(document["band_hz"], (json{500, 1000}));
  ASSERT_EQ(document["modes"].size(), 1U);
  EXPECT_NEAR(document["modes"][0]["frequency_hz"], 700, 0.01);
}

TEST_F(AnalyzeCommand, AnalysesTheRunsOfAFileAsSeparateTests) {
  const json document = document_of({file("runs.h5")});
  ASSERT_EQ(document["runs"].size(), 2U);
  for (std::size_t run = 0; run < 2; ++run) {
    EXPECT_EQ(document["runs"][run]["run"], run);
    EXPECT_EQ(document["runs"][run]["hits"].size(), 2U);
    EXPECT_EQ(document["runs"][run]["modes"].size(), 2U);
  }
  EXPECT_THAT(analyze({file("runs.h5")}).out, AllOf(HasSubstr("test 0"), HasSubstr("test 1")));
}

TEST_F(AnalyzeCommand, GroupsFilesAsHitsPointsOrTests) {
  const json hits = document_of({file("bat.h5"), file("bat.csv")});
  ASSERT_EQ(hits["hits"].size(), 6U);
  EXPECT_EQ(hits["hits"][3]["file"], file("bat.csv"));
  EXPECT_EQ(hits["hits"][3]["point"], 0);
  EXPECT_EQ(hits["modes"][0]["residues"].size(), 2U);
  const json points = document_of({file("bat.h5"), file("bat.csv"), "--files", "points"});
  EXPECT_EQ(points["hits"][3]["point"], 1);
  EXPECT_EQ(points["modes"][0]["residues"].size(), 4U);
  const json tests = document_of({file("bat.h5"), file("bat.csv"), "--files", "tests"});
  ASSERT_EQ(tests["runs"].size(), 2U);
  EXPECT_EQ(tests["runs"][1]["inputs"][0]["path"], file("bat.csv"));
}

TEST_F(AnalyzeCommand, ReportsWithoutAUsableHit) {
  auto outcome = analyze({file("missing.h5"), "--json"});
  EXPECT_EQ(outcome.code, 4);
  const json document = test::parse_json(outcome.out);
  EXPECT_EQ(document["hits"][0]["accepted"], false);
  EXPECT_EQ(document["hits"][0]["findings"][0]["code"], "no_pulse");
  EXPECT_THAT(document["modes"], IsEmpty());
  EXPECT_THAT(violations_in(document), IsEmpty());
  outcome = analyze({file("missing.h5")});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("no hammer pulse"), HasSubstr("no hit has a pulse of the force")));
}

}  // namespace percuss::analyze_command_test
