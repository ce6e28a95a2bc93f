#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::model_bat_command_test {

using test::run_percuss;
using testing::HasSubstr;

constexpr const char* kProfile = "# end cm, diameter mm\nend,diameter\n2,50\n40,26\n50,40\n82,62\n";

class ModelBatCommand : public testing::Test {
 protected:
  ModelBatCommand() { test::write_bytes(folder_.file("bat.csv"), kProfile); }

  test::ProcessOutcome run(std::vector<std::string> options) {
    std::vector<std::string> words{"model", "bat", "--profile", "bat.csv", "--profile-unit", "cm:mm"};
    words.insert(words.end(), options.begin(), options.end());
    return run_percuss(words, {.folder = folder_.path()});
  }

  test::ScratchFolder folder_;
};

TEST_F(ModelBatCommand, PrintsADocumentThatFitsItsSchema) {
  for (const auto& options : std::vector<std::vector<std::string>>{{"--json"}, {"--json", "--wave", "0.6"}}) {
    const auto outcome = run(options);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto document = test::parse_json(outcome.out);
    EXPECT_THAT(test::schema_violations(document, test::schema_named("model-bat")), testing::IsEmpty());
    EXPECT_NEAR(document["frequency_hz"][0].get<double>(), 161.04226, 1e-4);
    EXPECT_EQ(document["node_m"][1].size(), 3U);
    EXPECT_NEAR(document["mass_kg"].get<double>(), 0.86498, 1e-5);
    EXPECT_EQ(document["curve"].size(), 61U);
    EXPECT_EQ(document.contains("wave"), options.size() > 1);
  }
}

TEST_F(ModelBatCommand, WritesTableAndPictureOfSpeedsOrWave) {
  ASSERT_EQ(run({"--modes", "10", "--at", "0.5:0.1:0.8", "-o", "a.csv", "-o", "a.svg"}).code, 0);
  EXPECT_EQ(test::lines_of(test::bytes_of(folder_.file("a.csv"))).size(), 5U);
  EXPECT_THAT(test::bytes_of(folder_.file("a.svg")), testing::StartsWith("<svg "));
  ASSERT_EQ(run({"--modes", "10", "--wave", "0.6", "--wave-times", "0:0.001:0.002", "-o", "w.csv"}).code, 0);
  EXPECT_EQ(test::lines_of(test::bytes_of(folder_.file("w.csv")))[0],
            "z_m,deflection_m_0_s,deflection_m_0.001_s,deflection_m_0.002_s");
}

TEST_F(ModelBatCommand, NamesTheInvalidOption) {
  for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{{"--density", "-1"},
                                                                                      {"--young", "0"},
                                                                                      {"--shear", "nan"},
                                                                                      {"--ball-mass", "0"},
                                                                                      {"--cor", "0"},
                                                                                      {"--modes", "0"},
                                                                                      {"--at", "0:0.1:2"},
                                                                                      {"--wave", "2"},
                                                                                      {"--profile-unit", "cm"}}) {
    const auto outcome = run({option, value});
    EXPECT_EQ(outcome.code, 2) << option << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(option));
    EXPECT_EQ(test::lines_of(outcome.err).size(), 1U) << outcome.err;
  }
}

TEST_F(ModelBatCommand, NamesTheInvalidLineOfTheProfile) {
  for (const auto& [text, named] : std::vector<std::pair<std::string, std::string>>{{"", "bat.csv"},
                                                                                    {"# nothing\n", "bat.csv"},
                                                                                    {"2,50\n1,40\n", "line 2"},
                                                                                    {"2,50\n2,40\n", "line 2"},
                                                                                    {"2,50\nnan,40\n", "line 2"},
                                                                                    {"2,50\n4,inf\n", "line 2"},
                                                                                    {"2,50\n4,-40\n", "line 2"},
                                                                                    {"2,50\n4\n", "line 2"},
                                                                                    {"2,50,1\n4,40,1\n", "line 1"},
                                                                                    {"0,50\n4,40\n", "line 1"},
                                                                                    {"2,50\n1e9,40\n", "line 2"},
                                                                                    {"2,50\n4,x\n", "line 2"}}) {
    test::write_bytes(folder_.file("bat.csv"), text);
    const auto outcome = run({});
    EXPECT_EQ(outcome.code, 3) << text;
    EXPECT_THAT(outcome.err, HasSubstr(named)) << text;
    EXPECT_EQ(test::lines_of(outcome.err).size(), 1U) << outcome.err;
  }
}

TEST_F(ModelBatCommand, RejectsTooManySlices) {
  std::string text;
  for (int i = 1; i <= 1001; ++i) text += std::to_string(0.05 * i) + ",40\n";
  test::write_bytes(folder_.file("bat.csv"), text);
  const auto outcome = run({});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("more than 1000 lines"));
}

}  // namespace percuss::model_bat_command_test
