#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::metrics_command_test {

using test::run_percuss;
using testing::HasSubstr;

constexpr double kRounding = 1e-10;  // of the conversion to SI units and back

nlohmann::json metrics_of(std::vector<std::string> options) {
  options.insert(options.begin(), {"metrics", "--json"});
  const auto outcome = run_percuss(options);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  auto document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("metrics")), testing::IsEmpty());
  return document;
}

TEST(MetricsCommand, ReproducesTheWorkedExamples) {
  const auto bbs = metrics_of({"--besr", "0.728", "--v-swing-mph", "66"});
  EXPECT_NEAR(bbs["bbs_mph"].get<double>(), 97.008, kRounding);
  EXPECT_TRUE(bbs["bbcor"].is_null() && bbs["drop"].is_null() && bbs["k"].is_null());
  const auto bat =
      metrics_of({"--length-in", "34", "--moi-oz-in2", "10450", "--ball-g", "145.4", "--z-in", "6", "--besr", "0.728"});
  EXPECT_NEAR(bat["k"].get<double>(), 0.237546, 5e-7);
  EXPECT_NEAR(bat["bbcor"].get<double>(), 0.519706, 5e-7);
  EXPECT_EQ(bat["equation"]["bbcor"], "(P9)");
  EXPECT_EQ(bat["equation"]["besr"], "as given");
  const std::string bbcor = bat["bbcor"].dump();
  const auto back =
      metrics_of({"--length-in", "34", "--moi-oz-in2", "10450", "--ball-g", "145.4", "--z-in", "6", "--bbcor", bbcor});
  EXPECT_NEAR(back["besr"].get<double>(), 0.728, 1e-12);
}

TEST(MetricsCommand, StatesEveryUncertaintyAndItsSources) {
  const auto bat = metrics_of({"--length-in", "34", "--weight-oz", "31", "--cg-in", "12.5", "--period-s", "1.42"});
  const double arm = 34 - 6 - 12.5, step = 0.0625 / std::sqrt(12.0);
  const auto& moi = bat["uncertainty"]["moi_oz_in2"];
  EXPECT_NEAR(moi["from"]["cg_in"].get<double>() / bat["moi_oz_in2"].get<double>(), step / arm, kRounding);
  EXPECT_EQ(moi["without"], nlohmann::json::array({"period_s"}));
  EXPECT_NEAR(bat["uncertainty"]["drop"]["std"].get<double>(), std::hypot(step, 0.005 / std::sqrt(12.0)), kRounding);
}

// 6 in from the tip, these metrics do not change with the length. The rounding error of this derivative is no ±,
// whatever the length.
TEST(MetricsCommand, TakesNoRoundingErrorForAnUncertainty) {
  for (const char* length_in : {"30", "31", "32", "33", "34"}) {
    const auto outcome =
        run_percuss({"metrics", "--length-in", length_in, "--z-in", "6", "--v-in-mph", "136", "--v-out-mph", "25"});
    EXPECT_THAT(outcome.out, HasSubstr("(P5); no ±: no resolution of z_in\n")) << length_in;
    EXPECT_THAT(outcome.out, HasSubstr("(P7); no ±: no resolution of z_in, v_in_mph, v_out_mph\n")) << length_in;
    EXPECT_THAT(outcome.out, testing::Not(HasSubstr("± without"))) << length_in;
  }
}

TEST(MetricsCommand, AcceptsTimesOfALightGate) {
  const auto bat = metrics_of(
      {"--length-in", "34", "--weight-oz", "31", "--cg-in", "12.5", "--gate-times-s", "0.10,0.83,1.52,2.25,2.94,3.67"});
  const auto same = metrics_of({"--length-in", "34", "--weight-oz", "31", "--cg-in", "12.5", "--period-s", "1.42"});
  EXPECT_NEAR(bat["moi_oz_in2"].get<double>(), same["moi_oz_in2"].get<double>(), 1e-7);
}

TEST(MetricsCommand, RecordsTheProfileAndRoundsOnRequest) {
  const std::vector<std::string> options{"--length-in", "33.96",         "--weight-oz",
                                         "31.0524",     "--diameter-in", "2.6254,2.61"};
  const auto plain = metrics_of(options);
  EXPECT_EQ(plain["profile"]["length_in"], 33.9375);
  EXPECT_EQ(plain["profile"]["weight_oz"], 31.05);
  EXPECT_EQ(plain["profile"]["rings"][0]["diameter_in"], 2.625);
  EXPECT_EQ(plain["profile"]["rings"][1]["z_in"], 4);
  EXPECT_NEAR(plain["drop"].get<double>(), 31.0524 - 33.96, kRounding);
  auto rounded = options;
  rounded.emplace_back("--round");
  EXPECT_NEAR(metrics_of(rounded)["drop"].get<double>(), 31.05 - 33.9375, kRounding);
}

TEST(MetricsCommand, WritesFilesAndATable) {
  const test::ScratchFolder folder;
  const auto outcome = run_percuss({"metrics", "--length-in", "34", "--weight-oz", "31", "-o", "a.csv", "-o", "a.json"},
                                   {.folder = folder.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("class -3"));
  EXPECT_THAT(test::lines_of(test::bytes_of(folder.file("a.csv"))).at(1), testing::StartsWith("drop,-3"));
  EXPECT_EQ(test::parse_json(test::bytes_of(folder.file("a.json")))["profile"]["drop_class"], -3);
}

TEST(MetricsCommand, ReportsThatNoMetricFollows) {
  const auto outcome = run_percuss({"metrics", "--length-in", "33"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("no metric follows from these readings"));
}

TEST(MetricsCommand, NeedsAReading) {
  const auto outcome = run_percuss({"metrics"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("no reading is given"));
}

TEST(MetricsCommand, NamesTheInvalidOption) {
  for (const auto& [named, options] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"--length-in", {"--length-in", "-1"}},
           {"--length-in", {"--length-in", "12"}},
           {"--z-in", {"--length-in", "34", "--z-in", "29"}},
           {"--cg-in", {"--length-in", "34", "--cg-in", "29"}},
           {"--weight-oz", {"--weight-oz", "nan"}},
           {"--period-s", {"--period-s", "0"}},
           {"--period-s", {"--period-s", "1.4", "--gate-times-s", "1,2,3"}},
           {"--gate-times-s", {"--gate-times-s", "1,2"}},
           {"--gate-times-s", {"--gate-times-s", "3,2,1"}},
           {"--crossings-per-period", {"--crossings-per-period", "3"}},
           {"--besr", {"--besr", "0.7", "--bbcor", "0.5"}},
           {"--besr", {"--besr", "0.7", "--v-in-mph", "136", "--v-out-mph", "30"}},
           {"--moi-oz-in2", {"--moi-oz-in2", "1e4", "--period-s", "1"}},
           {"--diameter-in", {"--diameter-in", "1,2,3,4,5,6,7,8"}},
           {"--diameter-in", {"--diameter-in", "-2"}}}) {
    std::vector<std::string> words{"metrics"};
    words.insert(words.end(), options.begin(), options.end());
    const auto outcome = run_percuss(words);
    EXPECT_EQ(outcome.code, 2) << named;
    EXPECT_THAT(outcome.err, HasSubstr(named));
    EXPECT_EQ(test::lines_of(outcome.err).size(), 1U) << outcome.err;
  }
}

TEST(MetricsCommand, ComputesATableThatAStudyReads) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("b.csv"),
                    "id,material,length_in,weight_oz,moi_oz_in2,besr,hoop1_hz\nx,composite,33,30,9600,0.71,1800\n"
                    "y,composite,34,31,10450,0.728,\n");
  const auto outcome =
      run_percuss({"metrics", "b.csv", "--ball-g", "145.4", "--z-in", "6", "-o", "m.csv", "-o", "m.json"},
                  {.folder = folder.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("note: all bats: the swing model"));
  const auto document = test::parse_json(test::bytes_of(folder.file("m.json")));
  EXPECT_THAT(test::schema_violations(document, test::schema_named("metrics")), testing::IsEmpty());
  const auto one = metrics_of({"--length-in", "34", "--weight-oz", "31", "--moi-oz-in2", "10450", "--ball-g", "145.4",
                               "--z-in", "6", "--besr", "0.728", "--bat-id", "y", "--bat", "material=composite"});
  for (const char* key : {"bbcor", "bbs_mph", "drop", "k"}) EXPECT_EQ(document["bats"][1][key], one[key]) << key;
  EXPECT_EQ(document["bats"][0]["bat"]["properties"]["hoop1_hz"], 1800);
  for (const char* file : {"m.csv", "m.json"}) {
    const auto study = run_percuss({"study", file, "--json"}, {.folder = folder.path()});
    ASSERT_EQ(study.code, 0) << study.err;
    EXPECT_EQ(test::parse_json(study.out)["groups"][0]["states"], 2) << file;
  }
  test::write_bytes(folder.file("one.json"), one.dump());
  EXPECT_EQ(run_percuss({"study", "one.json"}, {.folder = folder.path()}).code, 0);
}

TEST(MetricsCommand, NamesTheRowOfAContradiction) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("b.csv"), "id,length_in,z_in\na,33,6\nb,33,28\n");
  const auto outcome = run_percuss({"metrics", "b.csv"}, {.folder = folder.path()});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("z_in lies behind the pivot (b.csv, line 3"));
  EXPECT_EQ(run_percuss({"metrics", "b.csv", "--bat-id", "a"}, {.folder = folder.path()}).code, 2);
}

// 6 in from the tip, the contact speed of every bat is 136 mph: its derivative with respect to the length is zero.
TEST(MetricsCommand, ShowsNoUncertaintyOfTermsThatCancel) {
  for (const char* length : {"31", "32", "32.5", "33", "33.7"}) {
    const std::vector<std::string> options{"--length-in", length, "--z-in", "6"};
    const auto contact = metrics_of(options)["uncertainty"]["v_contact_mph"];
    EXPECT_EQ(contact["std"], 0) << length;
    EXPECT_TRUE(contact["from"].empty()) << length;
    auto words = options;
    words.insert(words.begin(), "metrics");
    EXPECT_THAT(run_percuss(words).out, HasSubstr("  136  mph"));
  }
}

// Texts of the user need not be UTF-8.
TEST(MetricsCommand, WritesAnIdOfAnyBytes) {
  const auto outcome =
      run_percuss({"metrics", "--length-in", "33", "--weight-oz", "30", "--bat-id", "W\xe9", "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(test::parse_json(outcome.out)["bat"]["id"], "W\xef\xbf\xbd");
}

}  // namespace percuss::metrics_command_test
