#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/rejection.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::model_shell_command_test {

using test::run_percuss;

nlohmann::json document_of(std::vector<std::string> options) {
  options.insert(options.begin(), {"model", "shell", "--json"});
  const auto outcome = run_percuss(options);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  auto document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("model-shell")), testing::IsEmpty());
  return document;
}

TEST(ModelShellCommand, PrintsADocumentThatFitsItsSchema) {
  const auto document = document_of({"--modes", "2"});
  EXPECT_NEAR(document["ring_hz"].get<double>(), 1550, 0.5);
  EXPECT_NEAR(document["flugge_hz"][0].get<double>(), 1756, 0.5);
  EXPECT_EQ(document["flugge_hz"].size(), 2U);
}

TEST(ModelShellCommand, FitsModulusAndWall) {
  const auto young = document_of({"--measured", "2:1:1700:5"});
  EXPECT_NEAR(young["flugge_hz"][0].get<double>(), 1700, 1e-6);
  EXPECT_EQ(young["fit"]["wall_std_m"], 0);
  const auto both = document_of({"--measured", "2:1:1700:2,2:3:4300:4,3:1:4500:4", "--fit", "both"});
  EXPECT_GT(both["fit"]["wall_std_m"], 0);
  EXPECT_EQ(both["fit"]["points"].size(), 3U);
}

TEST(ModelShellCommand, WritesTableAndPicture) {
  const test::ScratchFolder folder;
  const auto outcome = run_percuss({"model", "shell", "-o", "a.csv", "-o", "a.svg"}, {.folder = folder.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(test::lines_of(test::bytes_of(folder.file("a.csv")))[0], "m,flugge_hz");
  EXPECT_THAT(test::bytes_of(folder.file("a.svg")), testing::StartsWith("<svg "));
}

TEST(ModelShellCommand, NamesTheInvalidOption) {
  for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{{"--outer-diameter", "-1"},
                                                                                      {"--wall", "0.04"},
                                                                                      {"--length", "0"},
                                                                                      {"--young", "nan"},
                                                                                      {"--poisson", "0.5"},
                                                                                      {"--n", "1"},
                                                                                      {"--modes", "0"},
                                                                                      {"--measured", "2:1:1700"},
                                                                                      {"--measured", "1:1:1700:5"},
                                                                                      {"--fit", "ring"}}) {
    test::expect_usage_error({"model", "shell", option, value}, option);
  }
}

}  // namespace percuss::model_shell_command_test
