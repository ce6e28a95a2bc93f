#include <gtest/gtest.h>

#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"

// Options take numbers with a unit.
namespace percuss::option_units_test {

using test::run_percuss;

nlohmann::json document_of(std::vector<std::string> words) {
  words.emplace_back("--json");
  const auto outcome = run_percuss(words);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.code == 0 ? test::parse_json(outcome.out) : nlohmann::json();
}

TEST(OptionUnits, ConvertToTheUnitOfTheOption) {
  const auto si =
      document_of({"model", "rigid", "--ball-speed", "60.79744", "--bat-mass", "0.85048569375", "--at", "0:0.1:0.2"});
  const auto lab = document_of({"model", "rigid", "--ball-speed", "136mph", "--bat-mass", "30oz", "--at", "0:0.1:0.2"});
  ASSERT_EQ(si["curve"].size(), lab["curve"].size());
  EXPECT_NEAR(si["best"]["exit_speed_mps"].get<double>(), lab["best"]["exit_speed_mps"].get<double>(), 1e-9);
  const auto inches = document_of({"metrics", "--length-in", "34", "--weight-oz", "31"});
  const auto metric = document_of({"metrics", "--length-in", "86.36 cm", "--weight-oz", "878.835216875g"});
  EXPECT_NEAR(inches["drop"].get<double>(), metric["drop"].get<double>(), 1e-9);
  EXPECT_EQ(document_of({"metrics", "--length-in", "34in", "--weight-oz", "31oz"})["drop"], inches["drop"]);
}

TEST(OptionUnits, RefuseUnitsOfAnotherKindAndValuesOutsideTheLimits) {
  for (const char* length : {"34kg", "34 furlongs", "-34cm", "cm", "34in ch", "in2"})
    EXPECT_EQ(run_percuss({"metrics", "--length-in", length}).code, 2) << length;
}

}  // namespace percuss::option_units_test
