#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "support/files/synthetic_files.hpp"
#include "support/json.hpp"
#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// Options of percuss analyze that override its choices, and the errors of invalid ones.
namespace percuss::analyze_choices_test {

using nlohmann::json;
using test::run_percuss;
using testing::AllOf;
using testing::HasSubstr;

class AnalyzeChoices : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::ScratchFolder>();
    test::write_small_test(path(),
                           R"("hits": 3, "faults": [{"hit": 1, "kind": "double", "delay_s": 0.02, "ratio": 0.3}])");
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::string path() { return folder_->file("bat.h5"); }
  static json document_of(std::vector<std::string> options) {
    options.insert(options.begin(), {"analyze", path(), "--json"});
    const auto outcome = run_percuss(options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    json document = test::parse_json(outcome.out);
    EXPECT_THAT(test::schema_violations(document, test::schema_named("analysis")), testing::IsEmpty());
    return document;
  }
  /// The message on standard error. Expects one line there, and nothing on standard output.
  static std::string rejection_of(std::vector<std::string> options, int code) {
    options.insert(options.begin(), {"analyze", path()});
    const auto outcome = run_percuss(options);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(test::lines_of(outcome.err).size(), 1U) << outcome.err;
    return outcome.err;
  }
  inline static std::unique_ptr<test::ScratchFolder> folder_;
};

TEST_F(AnalyzeChoices, StoresNoOptionsByDefault) {
  const json document = document_of({});
  EXPECT_FALSE(document.contains("options"));
  EXPECT_EQ(document["hits"][1]["accepted"], false);
  EXPECT_FALSE(document["hits"][1].contains("by_user"));
  const json& finding = document["hits"][1]["findings"][0];
  EXPECT_EQ(finding["code"], "double_hit");
  EXPECT_EQ(finding["severity"], "reject");
  EXPECT_NEAR(finding["value"], 0.3, 0.03);
  EXPECT_NEAR(finding["delay_s"], 0.02, 0.001);
}

TEST_F(AnalyzeChoices, AcceptsAndRejectsHitsAgainstTheirFindings) {
  const json document = document_of({"--accept-hit", "2", "--reject-hit", "1"});
  EXPECT_EQ(document["options"]["accept_hits"], (json{1}));
  EXPECT_EQ(document["options"]["reject_hits"], (json{0}));
  EXPECT_EQ(document["hits"][0]["accepted"], false);
  EXPECT_EQ(document["hits"][0]["by_user"], true);
  EXPECT_EQ(document["hits"][1]["accepted"], true);
  EXPECT_EQ(document["hits"][1]["by_user"], true);
  EXPECT_EQ(document["hits"][1]["findings"][0]["code"], "double_hit");
  EXPECT_EQ(document["hits"][2]["accepted"], true);
  EXPECT_FALSE(document["hits"][2].contains("by_user"));
}

// A hit without a pulse has no FRF: the option cannot change that.
TEST_F(AnalyzeChoices, SaysWhyAHitWithoutAPulseCannotBeAccepted) {
  const std::string missed = folder_->file("missed.h5");
  test::write_small_test(missed, R"("hits": 3, "faults": [{"hit": 1, "kind": "missing"}])");
  const json document = test::parse_json(run_percuss({"analyze", missed, "--accept-hit", "all", "--json"}).out);
  EXPECT_EQ(document["hits"][1]["accepted"], false);
  EXPECT_FALSE(document["hits"][1].contains("by_user"));
  EXPECT_EQ(document["warnings"][0]["code"], "accept_refused");
  EXPECT_THAT(document["warnings"][0]["message"], testing::StartsWith("hit 2 cannot be accepted"));
}

TEST_F(AnalyzeChoices, OffersToAcceptAHitOnlyWhereThatIsPossible) {
  const std::string dead = folder_->file("dead.h5");
  test::write_small_test(dead,
                         R"("hits": 2, "faults": [{"hit": 0, "kind": "missing"}, {"hit": 1, "kind": "missing"}])");
  for (const char* command : {"analyze", "survey"}) {
    const auto outcome = run_percuss({command, dead});
    EXPECT_EQ(outcome.code, 4) << command << outcome.err;
    EXPECT_THAT(outcome.out + outcome.err, testing::Not(HasSubstr("accept-hit"))) << command;
  }
  EXPECT_THAT(run_percuss({"analyze", dead}).out, HasSubstr("no hit has a pulse of the force"));
  EXPECT_THAT(run_percuss({"analyze", dead, "--accept-hit", "all"}).out, HasSubstr("hits 1, 2 cannot be accepted"));
  const auto rejected = run_percuss({"analyze", path(), "--reject-hit", "all"});
  EXPECT_EQ(rejected.code, 4);
  EXPECT_THAT(rejected.out, HasSubstr("it (--accept-hit)"));
}

TEST_F(AnalyzeChoices, ReportsTheRequestedNumberOfModes) {
  const json document = document_of({"--modes", "1"});
  EXPECT_EQ(document["options"]["modes"], 1);
  EXPECT_EQ(document["modes"].size(), 1U);
}

// The spec has a bending mode at 200 Hz and a hoop mode at 700 Hz. Orders count all modes, not only the requested ones.
TEST_F(AnalyzeChoices, KeepsTheOrdersOfAllModes) {
  const json all = document_of({}), part = document_of({"--modes", "1"}), started = document_of({"--start", "702"});
  const json& kept = part["modes"][0];
  std::size_t matches = 0;
  for (const json& mode : all["modes"]) {
    if (mode["frequency_hz"] != kept["frequency_hz"]) continue;
    ++matches;
    EXPECT_EQ(mode["order"], kept["order"]);
    EXPECT_EQ(mode["family"], kept["family"]);
  }
  EXPECT_EQ(matches, 1U);
  EXPECT_TRUE(started["modes"][0]["order"].is_null());
}

TEST_F(AnalyzeChoices, FitsAtTheGivenFrequencies) {
  const json document = document_of({"--start", "199,702"});
  EXPECT_EQ(document["options"]["start_hz"], (json{199, 702}));
  ASSERT_EQ(document["modes"].size(), 2U);
  EXPECT_NEAR(document["modes"][0]["frequency_hz"], 200, 0.05);
  EXPECT_NEAR(document["modes"][1]["frequency_hz"], 700, 0.05);
}

TEST_F(AnalyzeChoices, FitsOneModeToARepeatedFrequency) {
  EXPECT_EQ(document_of({"--start", "702,199,702"})["modes"].size(), 2U);
}

TEST_F(AnalyzeChoices, CutsHitsAsRequested) {
  const json document =
      document_of({"--from", "0.02", "--to", "0.9", "--trigger", "50", "--pretrigger", "0.01", "--length", "0.7"});
  const json& options = document["options"];
  EXPECT_EQ(options["from_s"], 0.02);
  EXPECT_EQ(options["to_s"], 0.9);
  EXPECT_EQ(options["trigger_n"], 50);
  EXPECT_EQ(options["pretrigger_s"], 0.01);
  EXPECT_EQ(options["length_s"], 0.7);
  EXPECT_NEAR(document["hits"][0]["time_s"], 0.05, 0.003);
  EXPECT_NEAR(document["modes"][0]["frequency_hz"], 200, 0.05);
}

TEST_F(AnalyzeChoices, CorrectsDampingForTheExponentialWindow) {
  const json document = document_of({"--exponential", "0.001"});
  EXPECT_EQ(document["options"]["exponential_end"], 0.001);
  ASSERT_EQ(document["modes"].size(), 2U);
  const json& mode = document["modes"][0];
  EXPECT_NEAR(mode["damping_ratio"], 0.01, 1e-4);
  EXPECT_GT(mode["damping_ratio_raw"], 0.012);
}

TEST_F(AnalyzeChoices, StoresChangedSettings) {
  const json document = document_of({"--force-window", "off", "--overlay-db", "0.5", "--estimator", "h2"});
  EXPECT_EQ(document["options"]["force_window"], "off");
  EXPECT_EQ(document["options"]["overlay_db"], 0.5);
  EXPECT_EQ(document["options"]["estimator"], "H2");
}

TEST_F(AnalyzeChoices, ReportsAnInvalidChoiceInOneLine) {
  EXPECT_THAT(rejection_of({"--band", "60"}, 2), AllOf(HasSubstr("--band"), HasSubstr("LO:HI")));
  EXPECT_THAT(rejection_of({"--band", "900:60"}, 2), HasSubstr("--band"));
  EXPECT_THAT(rejection_of({"--band", "nan:60"}, 2), HasSubstr("--band"));
  EXPECT_THAT(rejection_of({"--band", "60:900:2"}, 2), HasSubstr("--band"));
  EXPECT_THAT(rejection_of({"--band", "60:9000"}, 3), AllOf(HasSubstr("--band"), HasSubstr("4096 Hz")));
  EXPECT_THAT(rejection_of({"--only", "hits,noise"}, 2), AllOf(HasSubstr("'noise'"), HasSubstr("coherence")));
  EXPECT_THAT(rejection_of({"--accept-hit", "7"}, 3), AllOf(HasSubstr("no hit 7"), HasSubstr("count from 1")));
  EXPECT_THAT(rejection_of({"--accept-hit", "1", "--reject-hit", "1"}, 2),
              HasSubstr("--accept-hit and --reject-hit both name hit 1"));
  EXPECT_THAT(rejection_of({"--accept-hit", "-1"}, 2), HasSubstr("--accept-hit"));
  EXPECT_THAT(rejection_of({"--reject-hit", "0"}, 2), HasSubstr("hits count from 1"));
  EXPECT_THAT(rejection_of({"--modes", "0"}, 2), HasSubstr("--modes"));
  EXPECT_THAT(rejection_of({"--start", "-5"}, 2), HasSubstr("--start"));
  EXPECT_THAT(rejection_of({"--from", "0.5", "--to", "0.2"}, 2), HasSubstr("--to"));
  EXPECT_THAT(rejection_of({"--from", "7"}, 3), AllOf(HasSubstr("--from"), HasSubstr(path())));
  EXPECT_THAT(rejection_of({"--exponential", "2"}, 2), HasSubstr("--exponential"));
  EXPECT_THAT(rejection_of({"--estimator", "h3"}, 2), HasSubstr("--estimator"));
  EXPECT_THAT(rejection_of({"--files", "all"}, 2), HasSubstr("--files"));
  EXPECT_THAT(rejection_of({"--nonsense"}, 2), HasSubstr("--nonsense"));
  EXPECT_THAT(rejection_of({path()}, 2), HasSubstr("twice"));
}

TEST_F(AnalyzeChoices, UsesTheNamedChannelsAndUnits) {
  test::write_bytes(folder_->file("lab.csv"), [] {
    std::string text = "a;b;c\n";
    for (int i = 0; i < 2000; ++i)
      text += std::to_string(i % 7) + ";" + (i >= 100 && i < 110 ? "0,5" : "0,0") + ";" + std::to_string(i % 5) + "\n";
    return text;
  }());
  const auto outcome =
      run_percuss({"analyze", folder_->file("lab.csv"), "--json", "--fs", "1000", "--force-channel", "b",
                   "--accel-channel", "3", "--unit", "g", "--force-unit", "lbf", "--only", "hits"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = test::parse_json(outcome.out);
  EXPECT_EQ(document["fs_hz"], 1000);
  EXPECT_NEAR(document["hits"][0]["peak_force_n"], 0.5 * 4.4482216152605, 0.3);
}

TEST_F(AnalyzeChoices, AppliesAChannelSetUp) {
  test::write_bytes(
      folder_->file("setup.json"),
      R"([{"name": "accel 1", "role": "acceleration", "angle_deg": 30}, {"name": "accel 2", "role": "ignore"}])");
  const json document = document_of({"--setup", folder_->file("setup.json")});
  EXPECT_EQ(document["modes"][0]["residues"].size(), 1U);
}

TEST_F(AnalyzeChoices, RejectsStartsOutsideTheBand) {
  EXPECT_THAT(rejection_of({"--band", "60:1000", "--start", "1500"}, 2),
              HasSubstr("--start cannot be '1500': it lies outside the band 60:1000 Hz"));
}

// Hits on three different bats. Grouped as one test, they are averaged only if the user says so.
TEST_F(AnalyzeChoices, SeparatesFilesOfDifferentStructures) {
  std::vector<std::string> words{"analyze", "--band", "60:3200", "--only", "classes", "--effort", "quick"};
  for (const std::string preset : {"wood-bat", "aluminium-bat", "composite-bat"}) {
    words.push_back(folder_->file(preset + ".h5"));
    ASSERT_EQ(run_percuss({"synth", preset, "-o", words.back()}).code, 0);
  }
  const std::string out = run_percuss(words).out;
  EXPECT_THAT(out, AllOf(HasSubstr("test 0"), HasSubstr("test 2"), HasSubstr("different structures")));
  std::vector<std::string> joined = words;
  joined.insert(joined.end(), {"--files", "hits"});
  EXPECT_THAT(run_percuss(joined).out, HasSubstr("The modes belong to a mixture; analyse each file"));
  words.insert(words.end(), {"-o", folder_->file("mixed.html")});
  EXPECT_THAT(run_percuss(words).err,
              AllOf(HasSubstr("measured different structures or points"), HasSubstr("--files")));
}

TEST_F(AnalyzeChoices, StopAnAnalysisBeyondItsBudget) {
  EXPECT_THAT(rejection_of({"--budget", "1e-6"}, 4),
              AllOf(HasSubstr("not finished after its budget of 1e-06 s"), HasSubstr("raise the budget"),
                    HasSubstr("(--band, --effort, --budget)")));
  EXPECT_THAT(rejection_of({"--budget", "100,1e-6"}, 4), HasSubstr("more memory than its budget of 1e-06 GB"));
  EXPECT_THAT(rejection_of({"--budget", "1,2,3"}, 2), HasSubstr("--budget cannot be '1,2,3'"));
  EXPECT_EQ(document_of({"--budget", "1000,64"})["modes"], document_of({})["modes"]);
}

}  // namespace percuss::analyze_choices_test
