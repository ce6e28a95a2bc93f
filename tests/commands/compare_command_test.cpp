#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/rejection.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::compare_command_test {

using nlohmann::json;
using test::run_percuss;
using testing::HasSubstr;

TEST(CompareCommand, PairsFrequenciesOfModels) {
  const test::ScratchFolder folder;
  for (const char* support : {"torsion", "pinned", "clamped"}) {
    ASSERT_EQ(run_percuss(
                  {"model", "beam", "--support", support, "-o", folder.file(std::string(support) + ".json"), "--quiet"})
                  .code,
              0);
  }
  const auto outcome =
      run_percuss({"compare", "torsion.json", "clamped.json", "pinned.json", "--furthest", "40", "--json"},
                  {.folder = folder.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("compare")), testing::IsEmpty());
  EXPECT_GE(document["pairs"].size(), 4U);
  ASSERT_EQ(document["others"].size(), 1U);
  EXPECT_EQ(document["others"][0]["document"], 2);
}

TEST(CompareCommand, RejectsDocumentsThatItCannotCompare) {
  const test::ScratchFolder folder;
  const auto refused = [&](const std::string& text) {
    test::write_bytes(folder.file("x.json"), text);
    return test::rejection_of({"compare", folder.file("x.json"), folder.file("x.json")}, {".json"}, "x.json");
  };
  EXPECT_THAT(refused(""), HasSubstr("empty"));
  EXPECT_THAT(refused("{\"a\":"), HasSubstr("not JSON"));
  EXPECT_THAT(refused("[1]"), HasSubstr("schema"));
  EXPECT_THAT(refused("{\"schema\": \"percuss/other/1\"}"), HasSubstr("percuss/other/1"));
  EXPECT_THAT(refused("{\"schema\": \"percuss/model-beam/1\", \"frequency_hz\": [1, \"x\"]}"),
              HasSubstr("frequency_hz[1]"));
  EXPECT_THAT(refused("{\"schema\": \"percuss/analysis/1\", \"modes\": [{\"frequency_hz\": 1e999}]}"),
              HasSubstr("x.json"));
  EXPECT_THAT(refused(std::string(100000, '[')), HasSubstr("nested"));
  test::write_bytes(folder.file("one.json"), R"({"schema": "percuss/model-beam/1", "frequency_hz": [1]})");
  EXPECT_EQ(run_percuss({"compare", folder.file("one.json")}).code, 2);
}

}  // namespace percuss::compare_command_test
