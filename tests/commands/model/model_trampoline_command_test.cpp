#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <algorithm>

#include "support/files/csv_columns.hpp"
#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::model_trampoline_command_test {

using test::run_percuss;
using testing::HasSubstr;

nlohmann::json document_of(std::vector<std::string> options) {
  options.insert(options.begin(), {"model", "trampoline", "--json"});
  const auto outcome = run_percuss(options);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  auto document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("model-trampoline")), testing::IsEmpty());
  return document;
}

TEST(ModelTrampolineCommand, PrintsADocumentThatFitsItsSchema) {
  const auto document = document_of({});
  EXPECT_NEAR(document["wall_cor"].get<double>(), 0.48359, 0.5e-5);
  EXPECT_NEAR(document["peak"]["hoop_hz"].get<double>(), 1255.2, 0.05);
  EXPECT_NEAR(document["cor_10khz"].get<double>(), 0.4892, 0.5e-4);
  EXPECT_EQ(document["curve"].size(), 397U);
}

TEST(ModelTrampolineCommand, KnowsTheSoftball) {
  const auto document = document_of({"--ball", "softball", "--hoop", "500:50:1500"});
  EXPECT_NEAR(document["peak"]["hoop_hz"].get<double>(), 953.204, 0.01);
  EXPECT_EQ(document["constants"]["c2"], 100.5);
}

TEST(ModelTrampolineCommand, ComputesTheModalMassFromAFrequencyShift) {
  const auto document =
      document_of({"--extra-mass", "0.145", "--free-hoop", "2300", "--loaded-hoop", "1600", "--hoop", "2200:100:2400"});
  EXPECT_NEAR(document["modal_mass_kg"].get<double>(), 0.136, 0.5e-3);
  EXPECT_NEAR(document["curve"][1]["loaded_hoop_hz"].get<double>(), 1423, 0.5);
}

TEST(ModelTrampolineCommand, FitsTheExponentsFromOptionOrFile) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("ccor.csv"), "speed,cor,std\n26.8224,0.51922,0.004\n51.4096,0.49093,0.004\n");
  const auto from_option =
      document_of({"--fit-ccor", "26.8224:0.51922:0.004,51.4096:0.49093:0.004", "--hoop", "1000:100:1500"});
  const auto from_file = document_of({"--fit-ccor", folder.file("ccor.csv"), "--hoop", "1000:100:1500"});
  EXPECT_EQ(from_option, from_file);
  // A file may hold the points as the option does, and its name may have a colon.
  test::write_bytes(folder.file("a:b.txt"), "# CCOR\nspeed:cor:std\n26.8224:0.51922:0.004,51.4096:0.49093:0.004\r\n");
  EXPECT_EQ(document_of({"--fit-ccor", folder.file("a:b.txt"), "--hoop", "1000:100:1500"}), from_option);
  test::write_bytes(folder.file("bad.txt"), "26.8:0.519:0.004\n35.8:0.5\n");
  const auto bad = run_percuss({"model", "trampoline", "--fit-ccor", folder.file("bad.txt")});
  EXPECT_EQ(bad.code, 3);
  EXPECT_THAT(bad.err, HasSubstr("line 2"));
  EXPECT_EQ(from_option["constants"]["a"], from_option["fit"]["a"]);
  EXPECT_NEAR(from_option["fit"]["a"].get<double>(), 0.6495, 0.01);  // the COR has five digits
}

// Five speeds with errors of 0.004. A fit of both exponents, a and b, runs to its limit.
const std::string kNoisyCcor =  // NOLINT(cert-err58-cpp): a literal
    "26.8224:0.5242:0.004,35.7632:0.5028:0.004,40.2336:0.5036:0.004,44.704:0.4930:0.004,51.4096:0.4879:0.004";

bool warns(const nlohmann::json& document, const std::string& code) {
  const auto& all = document["warnings"];
  return std::any_of(all.begin(), all.end(), [&](const auto& w) { return w["code"] == code; });
}

TEST(ModelTrampolineCommand, SaysThatThePairIsNotDetermined) {
  const auto document = document_of({"--fit-ccor", kNoisyCcor, "--hoop", "100:100:10000"});
  EXPECT_TRUE(warns(document, "exponents_not_determined"));
  EXPECT_FALSE(document["fit"]["determined"].get<bool>());
  EXPECT_GT(document["peak"]["hoop_hz_high"].get<double>() - document["peak"]["hoop_hz_low"].get<double>(), 2000);
  EXPECT_GE(document["fit"]["family"].size(), 5U);
  const auto text = run_percuss({"model", "trampoline", "--fit-ccor", kNoisyCcor});
  EXPECT_THAT(text.out, HasSubstr("do not determine a and b"));
  EXPECT_THAT(text.out, HasSubstr("--hold"));
}

TEST(ModelTrampolineCommand, HoldsAnExponent) {
  const auto held = document_of({"--fit-ccor", kNoisyCcor, "--hold", "a=0.6495", "--hoop", "500:100:3000"});
  EXPECT_EQ(held["fit"]["a"], 0.6495);
  EXPECT_EQ(held["fit"]["held"], nlohmann::json({"a"}));
  EXPECT_TRUE(held["fit"]["a_std"].is_null());
  EXPECT_NEAR(held["peak"]["hoop_hz"].get<double>(), 1255, 5);
  EXPECT_GT(held["peak"]["hoop_hz_std"].get<double>(), 1);
  EXPECT_LT(held["peak"]["hoop_hz_std"].get<double>(), 5);
  EXPECT_FALSE(warns(held, "exponents_not_determined"));
  EXPECT_EQ(document_of({"--fit-ccor", kNoisyCcor, "--a", "0.6495", "--hoop", "500:100:3000"}), held);
  const auto both = document_of({"--fit-ccor", kNoisyCcor, "--a", "0.6495", "--b", "0.5202", "--hoop", "900:100:1500"});
  EXPECT_EQ(both["constants"]["b"], 0.5202);
  EXPECT_TRUE(both["fit"]["b_std"].is_null());
  for (const std::vector<std::string>& wrong :
       std::vector<std::vector<std::string>>{{"--fit-ccor", kNoisyCcor, "--hold", "c=1"},
                                             {"--fit-ccor", kNoisyCcor, "--hold", "a"},
                                             {"--fit-ccor", kNoisyCcor, "--hold", "a=-1"},
                                             {"--hold", "a=0.6"},
                                             {"--fit-ccor", kNoisyCcor, "--hold", "a=0.6", "--a", "0.7"}}) {
    std::vector<std::string> words{"model", "trampoline"};
    words.insert(words.end(), wrong.begin(), wrong.end());
    const auto outcome = run_percuss(words);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--hold"));
  }
}

TEST(ModelTrampolineCommand, SaysThatTheOptimumIsAnEnd) {
  const auto inside = document_of({"--hoop", "1000:100:1500"});
  EXPECT_FALSE(inside["peak"]["at_edge"].get<bool>());
  EXPECT_TRUE(inside["warnings"].empty());
  const auto outside = document_of({"--hoop", "1500:100:3000"});
  EXPECT_TRUE(outside["peak"]["at_edge"].get<bool>());
  EXPECT_TRUE(warns(outside, "optimum_at_edge"));
  EXPECT_THAT(run_percuss({"model", "trampoline", "--hoop", "1500:100:3000"}).out, HasSubstr("no maximum lies within"));
}

TEST(ModelTrampolineCommand, DrawsTheMeasuredPointsOverTheSpeed) {
  const test::ScratchFolder folder;
  const auto outcome = run_percuss({"model", "trampoline", "--fit-ccor", kNoisyCcor, "--hold", "a=0.6495", "--hoop",
                                    "900:100:1500", "-o", "a.csv", "-o", "a.svg"},
                                   {.folder = folder.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string picture = test::bytes_of(folder.file("a.svg"));
  EXPECT_THAT(picture, HasSubstr("CCOR over the speed"));
  EXPECT_THAT(picture, HasSubstr(">measured, ± std<"));
  EXPECT_THAT(test::bytes_of(folder.file("a.csv")), HasSubstr(",cor_low,cor_high"));
}

TEST(ModelTrampolineCommand, WritesTableAndPicture) {
  const test::ScratchFolder folder;
  const auto outcome = run_percuss({"model", "trampoline", "--hoop", "1000:100:1500", "-o", "a.csv", "-o", "a.svg"},
                                   {.folder = folder.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto lines = test::lines_of(test::bytes_of(folder.file("a.csv")));
  ASSERT_EQ(lines.size(), 7U);
  EXPECT_EQ(lines[0], "hoop_hz,cor,loaded_hoop_hz,contact_s,contacts,cor_over_wall,cor_over_10khz");
  EXPECT_THAT(test::bytes_of(folder.file("a.svg")), testing::StartsWith("<svg "));
}

TEST(ModelTrampolineCommand, NamesTheInvalidOption) {
  for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{{"--ball", "golf"},
                                                                                      {"--speed", "0"},
                                                                                      {"--m1", "-1"},
                                                                                      {"--m2", "nan"},
                                                                                      {"--c2", "-1"},
                                                                                      {"--k1", "0"},
                                                                                      {"--b", "1.7"},
                                                                                      {"--hoop", "0:25:100"},
                                                                                      {"--loaded-hoop", "1600"},
                                                                                      {"--fit-ccor", "1:2"},
                                                                                      {"--fit-ccor", "30:0.5:0"},
                                                                                      {"--extra-mass", "inf"}}) {
    const auto outcome = run_percuss({"model", "trampoline", option, value});
    EXPECT_EQ(outcome.code, 2) << option;
    EXPECT_THAT(outcome.err, HasSubstr(option));
    EXPECT_EQ(test::lines_of(outcome.err).size(), 1U) << outcome.err;
  }
}

TEST(ModelTrampolineCommand, NamesTheInvalidLine) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("ccor.csv"), "26.8,0.519,0.004\n51.4,nan,0.004\n");
  const auto outcome = run_percuss({"model", "trampoline", "--fit-ccor", folder.file("ccor.csv")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("ccor.csv: line 2"));
}

// A bat on the model's curve has no difference from it. The other bat has the difference of 0.05 that it was given.
TEST(ModelTrampolineCommand, ComparesMeasuredBats) {
  const test::ScratchFolder folder;
  const auto curve = document_of({"--hoop", "1000:500:2500"})["curve"];
  const std::string on_curve = curve[2]["cor"].dump();
  test::write_bytes(folder.file("bats.csv"),
                    "id,length_in,material,hoop1_hz,bbcor\na,33,composite,2000," + on_curve + "\nb,33,composite,1000," +
                        std::to_string(curve[0]["cor"].get<double>() - 0.05) + "\nc,33,wood,,0.48\n");
  const auto bats = document_of({"--hoop", "1000:500:2500", "--bats", folder.file("bats.csv")})["bats"];
  ASSERT_EQ(bats.size(), 2U);  // the third has no hoop mode
  EXPECT_NEAR(bats[0]["difference"].get<double>(), 0, 1e-12);
  EXPECT_NEAR(bats[1]["difference"].get<double>(), -0.05, 1e-6);
  const auto outcome = run_percuss(
      {"model", "trampoline", "--hoop", "1000:500:2500", "--bats", "bats.csv", "-o", "t.csv", "-o", "t.svg"},
      {.folder = folder.path()});
  EXPECT_THAT(outcome.out, HasSubstr("BBCOR minus the model's COR: mean -0.0250, standard deviation 0.0354"));
  EXPECT_THAT(test::bytes_of(folder.file("t.svg")), HasSubstr("BBCOR of bats"));
  EXPECT_THAT(test::bytes_of(folder.file("t.csv")), testing::StartsWith("hoop_hz,cor,loaded_hoop_hz,contact_s,contacts,"
                                                                        "cor_over_wall,cor_over_10khz"));
  // The rows of the bats follow those of the curve, with the model at their hoop frequency.
  auto table = test::csv_columns(folder.file("t.csv"));
  ASSERT_EQ(table["hoop_hz"].size(), 6U);
  EXPECT_TRUE(std::isnan(table["bbcor"][3]));
  EXPECT_EQ(table["hoop_hz"][4], 2000);
  EXPECT_EQ(table["cor"][4], table["cor"][2]);
  EXPECT_EQ(table["bbcor"][4], table["cor"][2]);
  EXPECT_NEAR(table["difference"][5], -0.05, 1e-6);
  for (const char* name : {"contact_s", "contacts", "cor_over_wall", "cor_over_10khz", "loaded_hoop_hz"})
    EXPECT_EQ(table[name][5], table[name][0]) << name;
  EXPECT_THAT(test::lines_of(test::bytes_of(folder.file("t.csv")))[6], testing::EndsWith(",b"));
  test::write_bytes(folder.file("none.csv"), "id,length_in,material,bbcor\nc,33,wood,0.48\n");
  EXPECT_EQ(run_percuss({"model", "trampoline", "--bats", folder.file("none.csv")}).code, 3);
}

}  // namespace percuss::model_trampoline_command_test
