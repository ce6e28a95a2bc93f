#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
  EXPECT_EQ(from_option["constants"]["a"], from_option["fit"]["a"]);
  EXPECT_NEAR(from_option["fit"]["a"].get<double>(), 0.6495, 0.01);  // the COR has five digits
}

TEST(ModelTrampolineCommand, WritesTableAndPicture) {
  const test::ScratchFolder folder;
  const auto outcome = run_percuss({"model", "trampoline", "--hoop", "1000:100:1500", "-o", "a.csv", "-o", "a.svg"},
                                   {.folder = folder.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto lines = test::lines_of(test::bytes_of(folder.file("a.csv")));
  ASSERT_EQ(lines.size(), 7U);
  EXPECT_EQ(lines[0], "hoop_hz,cor,loaded_hoop_hz,contact_s,contacts");
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

}  // namespace percuss::model_trampoline_command_test
