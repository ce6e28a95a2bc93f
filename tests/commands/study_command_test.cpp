#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/rejection.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::study_command_test {

using test::bytes_of;
using test::run_percuss;
using testing::HasSubstr;

class StudyCommand : public testing::Test {
 protected:
  void SetUp() override { test::write_bytes(folder_.file("bats.csv"), run_percuss({"study", "--example"}).out); }
  test::ProcessOutcome study(std::vector<std::string> words) {
    words.insert(words.begin(), "study");
    return run_percuss(words, {.folder = folder_.path()});
  }
  test::ScratchFolder folder_;
};

TEST_F(StudyCommand, PrintsADocumentThatFitsItsSchema) {
  const auto outcome = study({"bats.csv", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("study")), testing::IsEmpty());
  EXPECT_EQ(document["statements"].size(), 18U);
}

TEST_F(StudyCommand, PrintsVerdicts) {
  const auto outcome = study({"bats.csv"});
  EXPECT_THAT(outcome.out, HasSubstr("BBCOR of nonwood bats rises as the first hoop frequency falls"));
  EXPECT_THAT(outcome.out, HasSubstr("supported"));
}

TEST_F(StudyCommand, WritesEveryFigureReproducibly) {
  ASSERT_EQ(study({"bats.csv", "--figures", "a", "--quiet"}).code, 0);
  ASSERT_EQ(study({"bats.csv", "--figures", "b", "--quiet"}).code, 0);
  std::size_t pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.file("a"))) {
    const std::string name = entry.path().filename().string();
    EXPECT_EQ(bytes_of(entry.path().string()), bytes_of(folder_.file("b/" + name)));
    if (entry.path().extension() != ".svg") continue;
    ++pictures;
    EXPECT_THAT(bytes_of(entry.path().string()), testing::Not(HasSubstr("nan")));
  }
  EXPECT_GT(pictures, 55U);
  const std::string picture = bytes_of(folder_.file("a/besr-hoop1-nonwood-33.svg"));
  EXPECT_THAT(picture, HasSubstr("first hoop frequency, Hz"));
  EXPECT_THAT(picture, HasSubstr(">composite, ABI<"));
  EXPECT_THAT(picture, HasSubstr(">trend, 33 in<"));
}

TEST_F(StudyCommand, DrawsAModelOverTheHoopFigures) {
  test::write_bytes(folder_.file("m.json"), R"({"schema": "percuss/model-trampoline/1", "curve": [
      {"hoop_hz": 1000, "cor": 0.52}, {"hoop_hz": 2000, "cor": 0.50}, {"hoop_hz": 3000, "cor": 0.49}]})");
  ASSERT_EQ(study({"bats.csv", "--figures", "a", "--hoop-curve", "m.json"}).code, 0);
  EXPECT_THAT(bytes_of(folder_.file("a/besr-hoop1-nonwood-33.svg")), HasSubstr(">model × "));
  EXPECT_THAT(bytes_of(folder_.file("a/besr-moi-nonwood-33.svg")), testing::Not(HasSubstr(">model × ")));
  EXPECT_EQ(study({"bats.csv", "--hoop-curve", "m.json"}).code, 2);
}

TEST_F(StudyCommand, ReplacesIdsAndWritesTheKey) {
  test::write_bytes(folder_.file("t.csv"),
                    "id,maker,length_in,material,besr,moi_oz_in2\nSecret,Acme,33,wood,0.7,11000\n");
  const auto outcome = study({"t.csv", "--blind", "key.csv", "--table", "blind.csv", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out + bytes_of(folder_.file("blind.csv")),
              testing::Not(testing::AnyOf(HasSubstr("Secret"), HasSubstr("Acme"))));
  EXPECT_THAT(bytes_of(folder_.file("key.csv")), HasSubstr("AS001,Secret,,Acme,"));
  EXPECT_EQ(study({"t.csv", "--blind", "key.csv"}).code, 3);  // an existing key is not overwritten
}

TEST_F(StudyCommand, DescribesGroupsAndCountsPrograms) {
  const auto bats = [](const std::string& program, int first) {
    std::string rows;
    for (int i = 0; i < 6; ++i)
      rows += "b" + std::to_string(first + i) + ",33,aluminum," + program + "," + std::to_string(0.70 + 0.001 * i * i) +
              "," + std::to_string(10000 + 100 * i) + "\n";
    return rows;
  };
  test::write_bytes(folder_.file("p.csv"),
                    "id,length_in,material,program,besr,moi_oz_in2\n" + bats("", 0) + bats("bbcor", 10));
  const auto document = test::parse_json(study({"p.csv", "--json"}).out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("study")), testing::IsEmpty());
  EXPECT_EQ(document["figures"][0]["classes"][0]["association"]["bats"], 6);
  EXPECT_EQ(document["groups"][0]["states"], 12);
  const auto all = test::parse_json(study({"p.csv", "--json", "--program", "all"}).out);
  EXPECT_EQ(all["figures"][0]["classes"][0]["association"]["bats"], 12);
  EXPECT_EQ(study({"p.csv", "--program", "usssa"}).code, 3);
  const std::string text = study({"p.csv"}).out;
  EXPECT_THAT(text, HasSubstr("6 bats of the program bbcor are drawn"));
  EXPECT_THAT(text, HasSubstr("aluminum, new, bbcor"));
  ASSERT_EQ(study({"p.csv", "--figures", "f", "--quiet"}).code, 0);
  EXPECT_THAT(bytes_of(folder_.file("f/groups.csv")), HasSubstr("aluminum,all,all,12,besr,12,"));
}

TEST_F(StudyCommand, RejectsUnusableInput) {
  test::write_bytes(folder_.file("bad.csv"), "id,length_in,material\na,33,paper\n");
  test::rejection_of({"study", folder_.file("bad.csv")}, {".json", ".csv"}, "bat a");
  EXPECT_EQ(study({}).code, 2);
}

TEST_F(StudyCommand, ChecksThePathsOfKeyAndTableFirst) {
  std::filesystem::create_directory(folder_.file("folder"));
  std::filesystem::create_symlink("none.csv", folder_.file("link.csv"));
  for (const std::string option : {"--blind", "--table"}) {
    const auto refusal = [&](const std::string& path) {
      const auto outcome = study({"no-such-table.csv", option, path});
      EXPECT_EQ(outcome.code, 3) << option << " " << path;
      return outcome.err;
    };
    EXPECT_THAT(refusal("bats.csv"), HasSubstr("file exists (bats.csv)"));
    EXPECT_THAT(refusal("folder"), HasSubstr("is a folder (folder); name a file"));
    EXPECT_THAT(refusal("link.csv"), HasSubstr("is a link to a file that does not exist (link.csv)"));
    EXPECT_THAT(refusal("missing/t.csv"), HasSubstr("create the folder first"));
  }
}

TEST_F(StudyCommand, JoinsAnalysesThatNameTheirBat) {
  ASSERT_EQ(run_percuss({"synth", "wood-bat", "-o", "w.h5", "--quiet"}, {.folder = folder_.path()}).code, 0);
  const auto analysis =
      run_percuss({"analyze", "w.h5", "--bat-id", "W1", "--bat", "length_in=33", "--bat", "material=wood", "--bat",
                   "besr=0.7", "--effort", "quick", "--json", "-o", "w.json"},
                  {.folder = folder_.path()});
  ASSERT_EQ(analysis.code, 0) << analysis.err;
  const auto document = test::parse_json(analysis.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("analysis")), testing::IsEmpty());
  EXPECT_EQ(document["bat"]["properties"]["length_in"], 33);
  const auto joined = study({"w.json", "--table", "t.csv"});
  ASSERT_EQ(joined.code, 0) << joined.err;
  EXPECT_THAT(bytes_of(folder_.file("t.csv")), HasSubstr("W1,"));
  const auto figures = study({"w.json", "--json"});
  EXPECT_THAT(test::parse_json(figures.out)["figures"].dump(), HasSubstr("besr-bending1-wood-all"));
  for (const std::vector<std::string>& bad : std::vector<std::vector<std::string>>{
           {"--bat", "a=1"}, {"--bat-id", "x", "--bat", "a"}, {"--bat-id", "x", "--bat", "a=1", "--bat", "a=2"}}) {
    std::vector<std::string> words{"analyze", "w.h5"};
    words.insert(words.end(), bad.begin(), bad.end());
    EXPECT_EQ(run_percuss(words, {.folder = folder_.path()}).code, 2);
  }
}

// The unchanged documents of analyze, metrics and abi give the figure of a break-in.
TEST_F(StudyCommand, JoinsTheDocumentsOfSeveralCommands) {
  const auto run = [&](std::vector<std::string> words) { return run_percuss(words, {.folder = folder_.path()}); };
  const auto keep = [&](const char* name, const std::vector<std::string>& words) {
    const auto outcome = run(words);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    test::write_bytes(folder_.file(name), outcome.out);
  };
  run({"synth", "composite-bat", "-o", "bat.h5"});
  keep("a.json", {"analyze", "bat.h5", "--band", "60:3200", "--json", "--quiet", "--bat-id", "AS333", "--bat",
                  "material=composite"});
  keep("m.json",
       {"metrics", "--bat-id", "AS333", "--length-in", "33", "--weight-oz", "30", "--moi-oz-in2", "9600", "--json"});
  test::write_bytes(folder_.file("log.json"), R"({"bat": {"id": "AS333"}, "entries": [
    {"do": "compression", "force_lbf": [600, 600, 600, 600]}, {"do": "performance", "value": 0.71, "z_in": 6},
    {"do": "compression", "force_lbf": [500, 500, 500, 500]},
    {"do": "performance", "value": 0.72, "hoop_hz": 1700, "z_in": 6, "id": "AS334"}]})");
  keep("b.json", {"abi", "log.json", "--json"});
  ASSERT_EQ(run({"study", "a.json", "m.json", "b.json", "--figures", "f", "--quiet"}).code, 0);
  const auto rows = test::lines_of(bytes_of(folder_.file("f/besr-hoop1-trail-0-AS333.csv")));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_THAT(rows[1], testing::StartsWith("AS333,33,composite,new,"));
  EXPECT_THAT(rows[1], testing::EndsWith(",0.71"));
  constexpr double kNoise_Hz = 0.01;  // of the analysis
  EXPECT_NEAR(std::stod(rows[1].substr(std::string("AS333,33,composite,new,").size())), 1900, kNoise_Hz);
  EXPECT_EQ(rows[2], "AS334,33,composite,abi,1700,0.72");
}

}  // namespace percuss::study_command_test
