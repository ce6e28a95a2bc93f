#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/json.hpp"
#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::info_command_test {

using testing::HasSubstr;
using testing::IsEmpty;

class InfoCommand : public testing::Test {
 protected:
  InfoCommand() {
    test::write_bytes(file("a.csv"), "t_s,force_N,acc_g\n0,1,2\n0.1,3,4\n0.2,5,6\n");
    test::write_bytes(file("b.csv"), "t_s,CH1,CH2\n0,1,2\n0.1,3,4\n0.2,5,6\n");
  }
  std::string file(const std::string& name) const { return folder_.file(name); }
  static test::ProcessOutcome run(std::vector<std::string> arguments, const std::string& input = "") {
    arguments.insert(arguments.begin(), "info");
    return test::run_percuss(arguments, {.input = input});
  }
  test::ScratchFolder folder_;
};

TEST_F(InfoCommand, PrintsADescriptionOfAFile) {
  const auto outcome = run({file("a.csv")});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("CSV, 1 row of 3 samples, 10 Hz, 0.3 s"));
  EXPECT_THAT(outcome.out, HasSubstr("force_N"));
}

// The force can be read; the acceleration has a cell that is no number.
TEST_F(InfoCommand, DescribesAFileWhoseSamplesCannotBeRead) {
  std::string text = "t_s,force_N,acc_g\n";
  for (int i = 0; i < 400; ++i) text += std::to_string(i) + ",1," + (i == 300 ? "?" : "2") + "\n";
  test::write_bytes(file("cell.csv"), text);
  const auto outcome = run({file("cell.csv")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.out, HasSubstr("force_N"));
  EXPECT_THAT(outcome.out + outcome.err, HasSubstr("line 302"));
}

TEST_F(InfoCommand, DescribesTheOtherFilesIfOneIsBad) {
  const auto outcome = run({"--json", file("a.csv"), file("none.csv"), file("b.csv")});
  EXPECT_EQ(outcome.code, 3);
  const auto document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("info")), IsEmpty());
  ASSERT_EQ(document["files"].size(), 3U);
  EXPECT_EQ(document["files"][0]["fs_hz"], 10);
  EXPECT_EQ(document["files"][0]["channels"][1]["to_si"], 9.80665);
  EXPECT_THAT(document["files"][1]["error"], HasSubstr("no such file"));
  EXPECT_THAT(document["files"][2]["needs"], HasSubstr("no force column found among t_s, CH1, CH2"));
}

TEST_F(InfoCommand, NamesOptionsInTheTextButNotInTheDocument) {
  test::write_bytes(file("plain.csv"), "t_s,hammer,sensor\n0,1,2\n0.1,3,4\n0.2,5,6\n");
  const std::vector<std::string> words{"--force-channel", "hammer", "--accel-channel", "sensor", file("plain.csv")};
  const std::string text = run(words).out;
  EXPECT_THAT(text, HasSubstr("note: the unit of hammer is not stated; taken as N (--force-unit)"));
  EXPECT_THAT(text, HasSubstr("note: the unit of sensor is not stated; taken as m/s^2 (--unit)"));
  auto with_json = words;
  with_json.emplace_back("--json");
  const auto document = test::parse_json(run(with_json).out);
  EXPECT_EQ(document["files"][0]["notes"][0], "the unit of hammer is not stated; taken as N");
}

TEST_F(InfoCommand, PrintsTheOptionsOfAnErrorOnStandardErrorOnly) {
  const auto outcome = run({"--json", "--fs", "-5", file("a.csv")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, testing::EndsWith(" (--fs)\n"));
  EXPECT_THAT(test::parse_json(outcome.out)["files"][0]["error"], testing::Not(HasSubstr("--")));
}

TEST_F(InfoCommand, ListsTheColumnsOfUnknownChannels) {
  test::write_bytes(file("lab.csv"), "Sampling Rate(Hz),50\nCH No.,CH2,CH8\nUnit,cm/s2,V\n0,1,2\n0.02,3,4\n0.04,5,6\n");
  auto outcome = run({file("lab.csv")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::AllOf(HasSubstr("CSV, 3 columns, 50 Hz"), HasSubstr("CH2"), HasSubstr("cm/s2"),
                                          HasSubstr("--force-channel")));
  outcome = run({"--json", file("lab.csv")});
  const auto document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("info")), IsEmpty());
  EXPECT_EQ(document["files"][0]["columns"][2]["name"], "CH8");
  EXPECT_EQ(document["files"][0]["columns"][2]["number"], 3);
  EXPECT_EQ(document["files"][0]["columns"][2]["unit"], "V");
}

// Scopes write mV. info lists the columns and states that the sensitivity is missing; analyze refuses the file.
TEST_F(InfoCommand, ListsTheColumnsOfVoltsWithoutASensitivity) {
  test::write_bytes(file("scope.csv"), "Zeit (s);Hammer (mV);Beschl. (mV)\n0,0;1,5;2\n0,1;3;4\n0,2;5;6\n");
  auto outcome = run({file("scope.csv")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::AllOf(HasSubstr("CSV, 3 columns"), HasSubstr("3  Beschl. (mV)  mV"),
                                          HasSubstr("needed: the numbers are in mV"), HasSubstr("--accel-sensitivity"),
                                          testing::Not(HasSubstr("suggest"))));
  outcome = run({"--json", file("scope.csv"), file("a.csv")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("info")), IsEmpty());
  EXPECT_EQ(document["files"][0]["columns"][1]["name"], "Hammer (mV)");
  EXPECT_THAT(document["files"][0]["needs"], testing::EndsWith("give the sensitivity or the scale"));
  EXPECT_EQ(document["files"][1]["rows"], 1) << "the other file is described";
  outcome = test::run_percuss({"analyze", file("scope.csv")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err,
              testing::EndsWith("give the sensitivity or the scale (--accel-sensitivity, --accel-scale)\n"));
}

TEST_F(InfoCommand, AcceptsListsBeforeFiles) {
  const auto outcome =
      run({"--json", "--force-channel", "CH1", "--accel-channel", "CH2,t_s", "--angle", "-90,90", "--unit", "mg",
           "--force-sensitivity", "2", "--force-unit", "mV", "--position", "0.5", file("b.csv")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto channels = test::parse_json(outcome.out)["files"][0]["channels"];
  EXPECT_EQ(channels[0]["to_si"], 0.5);
  EXPECT_EQ(channels[1]["name"], "CH2");
  EXPECT_EQ(channels[1]["angle_deg"], -90);
  EXPECT_EQ(channels[2]["angle_deg"], 90);
  EXPECT_EQ(channels[2]["position_m"], 0.5);
}

TEST_F(InfoCommand, ReadsStandardInput) {
  const auto outcome = run({"-", "--json"}, file("a.csv"));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(test::parse_json(outcome.out)["files"][0]["path"], "-");
}

TEST_F(InfoCommand, AppliesAForceScalePerFile) {
  auto outcome = run({"--json", "--force-scale", "2,3", file("a.csv"), "--force-channel", "2", "--accel-channel", "3",
                      "--unit", "g", file("b.csv")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto files = test::parse_json(outcome.out)["files"];
  EXPECT_EQ(files[0]["channels"][0]["to_si"], 2);
  EXPECT_EQ(files[1]["channels"][0]["to_si"], 3);
  outcome = run({"--force-scale", "2,3,4", file("a.csv")});
  EXPECT_EQ(outcome.code, 2);
}

TEST_F(InfoCommand, PrintsASetUpThatItReads) {
  test::write_bytes(file("setup.json"), run({"--example"}).out);
  const auto outcome = run({"--json", "--accel-channel", "CH2", "--setup", file("setup.json"), file("b.csv")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(test::parse_json(outcome.out)["files"][0]["channels"][1]["position_m"], 0.15);
}

TEST_F(InfoCommand, RejectsInvalidValues) {
  EXPECT_EQ(run({}).code, 2);
  EXPECT_EQ(run({"--files", "many", file("a.csv")}).code, 2);
  EXPECT_EQ(run({"--unit", "furlong", file("a.csv")}).code, 3);
  EXPECT_EQ(run({"--fs", "nan", file("a.csv")}).code, 3);
  EXPECT_EQ(run({"--angle", "0,90", file("a.csv")}).code, 3);
}

TEST_F(InfoCommand, RejectsASetUpWithMisspeltNames) {
  test::write_bytes(file("typo.json"),
                    R"([{"name": "CH1", "role": "force"}, {"name": "CH9", "role": "acceleration"}])");
  const auto outcome = run({"--setup", file("typo.json"), file("b.csv")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("no column \"CH9\" among t_s, CH1, CH2"));
  EXPECT_THAT(outcome.err, HasSubstr("give the number from 1 in its place"));
}

}  // namespace percuss::info_command_test
