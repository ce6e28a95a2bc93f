#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/rejection.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::protocol_command_test {

using test::run_percuss;
using testing::HasSubstr;

// A session of six shots at 6 in from the tip, each with 136 mph before the impact and `v_out` after it.
std::string six_shots(const std::string& v_out) {
  std::string text = run_percuss({"certify", "--example-table"}).out;
  text = text.substr(0, text.find("z_in,")) + "z_in,ball,ball_g,v_in_mph,v_out_mph,angle_deg\n";
  for (int i = 0; i < 6; ++i) text += "6,b" + std::to_string(i) + ",145.4,136," + v_out + ",0\n";
  return text;
}

TEST(CertifyCommand, PrintsAnExampleThatItReads) {
  const test::ScratchFolder folder;
  for (const char* flag : {"--example", "--example-table"}) {
    const auto example = run_percuss({"certify", flag});
    ASSERT_EQ(example.code, 0) << example.err;
    test::write_bytes(folder.file("s"), example.out);
    const auto outcome = run_percuss({"certify", "s", "--json"}, {.folder = folder.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const auto document = test::parse_json(outcome.out);
    EXPECT_THAT(test::schema_violations(document, test::schema_named("certify")), testing::IsEmpty());
    EXPECT_EQ(document["next"]["action"], "shoot");
    EXPECT_EQ(document["next"]["z_in"], 6.0);
  }
}

TEST(CertifyCommand, ExitsWithCode5IfTheLimitIsExceeded) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("s.csv"), six_shots("34"));  // BESR = 34/136 + 0.002 (lot correction) + 0.5 = 0.752
  const auto failed =
      run_percuss({"certify", "s.csv", "-o", "s.svg", "-o", "t.csv", "-o", "s.json"}, {.folder = folder.path()});
  EXPECT_EQ(failed.code, 5);
  EXPECT_THAT(failed.out, HasSubstr("exceeds the limit of 0.728"));
  EXPECT_THAT(test::bytes_of(folder.file("s.svg")), testing::StartsWith("<svg "));
  EXPECT_EQ(test::lines_of(test::bytes_of(folder.file("t.csv"))).size(), 7U);
  EXPECT_EQ(run_percuss({"certify", "s.csv", "--limit", "0.8"}, {.folder = folder.path()}).code, 0);
  const auto bbcor =
      run_percuss({"certify", "s.csv", "--limit", "0.8", "--metric", "bbcor", "--json"}, {.folder = folder.path()});
  EXPECT_EQ(test::parse_json(bbcor.out)["metric"], "bbcor");
}

TEST(CertifyCommand, CountsShotsFromOne) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("s.csv"), six_shots("34") + "6,b6,145.4,120,34,0\n");
  const auto outcome = run_percuss({"certify", "s.csv"}, {.folder = folder.path()});
  EXPECT_THAT(outcome.out, HasSubstr("shot 7 does not count: 120.00 mph inbound"));
}

TEST(CertifyCommand, AsksForMetresPerSecond) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("s.csv"), six_shots("34") + "6,b6,145.4,60.8,13.6,0\n6,b7,145.4,70,34,0\n");
  const auto outcome = run_percuss({"certify", "s.csv", "--json"}, {.folder = folder.path()});
  EXPECT_THAT(outcome.out, HasSubstr("60.80 m/s are 136.01 mph; is the speed in m/s?"));
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr("70.00 m/s")));
}

TEST(CertifyCommand, StatesTheBatOnItsPage) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("s.json"), run_percuss({"certify", "--example"}).out);
  ASSERT_EQ(run_percuss({"certify", "s.json", "-o", "s.html"}, {.folder = folder.path()}).code, 0);
  const std::string page = test::bytes_of(folder.file("s.html"));
  for (const char* part : {"<dt>Bat</dt><dd>AS001</dd>", "<dt>Length, weight, MOI</dt>", "<dt>Metric</dt>", " in, "})
    EXPECT_THAT(page, HasSubstr(part));
}

// The session's limit, 0.728, is a limit of the metric NCAA BESR.
TEST(CertifyCommand, DoesNotJudgeByTheLimitOfAnotherMetric) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("s.csv"), six_shots("34"));
  const auto refused = run_percuss({"certify", "s.csv", "--metric", "bbcor"}, {.folder = folder.path()});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, testing::AllOf(HasSubstr("0.728, is a limit of ncaa_besr"), HasSubstr("--limit")));
  EXPECT_EQ(run_percuss({"certify", "s.csv", "--metric", "ncaa_besr"}, {.folder = folder.path()}).code, 5);
}

// The option and the file take the same limits.
TEST(CertifyCommand, RejectsALimitThatTheSessionMayNotState) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("s.csv"), six_shots("34"));
  const auto refused = run_percuss({"certify", "s.csv", "--limit", "50"}, {.folder = folder.path()});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--limit cannot be '50'; give a number from 0 to 2"));
  EXPECT_EQ(run_percuss({"certify", "s.csv", "--limit", "-0.1"}, {.folder = folder.path()}).code, 2);
  EXPECT_EQ(run_percuss({"certify", "s.csv", "--limit", "2"}, {.folder = folder.path()}).code, 0);
}

TEST(CertifyCommand, RejectsUnusableInput) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("bad.json"), "{\"bat\": 3}");
  test::rejection_of({"certify", folder.file("bad.json")}, {".json", ".csv", ".svg"}, "bad.json");
  EXPECT_EQ(run_percuss({"certify"}).code, 2);
  EXPECT_EQ(run_percuss({"certify", "x", "--metric", "y"}).code, 2);
}

TEST(AbiCommand, PrintsAnExampleThatItReads) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("l.json"), run_percuss({"abi", "--example"}).out);
  const auto outcome =
      run_percuss({"abi", "l.json", "--json", "-o", "l.svg", "-o", "l.csv"}, {.folder = folder.path()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("abi")), testing::IsEmpty());
  EXPECT_EQ(document["next"]["step"], 9);
  EXPECT_EQ(document["cycles"].size(), 2U);
  EXPECT_THAT(test::bytes_of(folder.file("l.svg")), testing::StartsWith("<svg "));
  EXPECT_THAT(run_percuss({"abi", "l.json"}, {.folder = folder.path()}).out, HasSubstr("step 9"));
}

TEST(AbiCommand, ExitsWithCode5IfTheBatFails) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("l.json"), run_percuss({"abi", "--example"}).out);
  const auto outcome = run_percuss({"abi", "l.json", "--limit", "0.719"}, {.folder = folder.path()});
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.out, HasSubstr("cycle 2: 0.7195 exceeds the limit"));
}

TEST(AbiCommand, RejectsALimitThatTheLogMayNotState) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("l.json"), run_percuss({"abi", "--example"}).out);
  const auto refused = run_percuss({"abi", "l.json", "--limit", "50"}, {.folder = folder.path()});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--limit cannot be '50'; give a number from 0 to 2"));
}

TEST(AbiCommand, RejectsALogOutOfOrder) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("l.json"), R"({"bat": {"id": "b"}, "entries": [{"do": "roll", "depth_in": 0.1}]})");
  const auto line = test::rejection_of({"abi", folder.file("l.json")}, {".json", ".csv", ".svg"}, "l.json, entries[0]");
  EXPECT_THAT(line, HasSubstr("step 1 comes next"));
}

TEST(AbiCommand, DrawsTheHoopFrequencyOverTheTests) {
  const test::ScratchFolder folder;
  const std::string log = run_percuss({"abi", "--example"}).out;
  test::write_bytes(folder.file("l.json"), log);
  run_percuss({"abi", "l.json", "-o", "l.svg"}, {.folder = folder.path()});
  EXPECT_THAT(test::bytes_of(folder.file("l.svg")), HasSubstr("hoop frequency over the break-in"));
  std::string without = log;
  for (const std::string hoop : {", \"hoop_hz\": 1970", ", \"hoop_hz\": 1880"})
    without.erase(without.find(hoop), hoop.size());
  test::write_bytes(folder.file("w.json"), without);
  run_percuss({"abi", "w.json", "-o", "w.svg"}, {.folder = folder.path()});
  EXPECT_THAT(test::bytes_of(folder.file("w.svg")), testing::Not(HasSubstr("hoop frequency")));
}

}  // namespace percuss::protocol_command_test
