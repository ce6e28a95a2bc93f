#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::model_rigid_command_test {

using test::run_percuss;
using testing::HasSubstr;

TEST(ModelRigidCommand, PrintsADocumentThatFitsItsSchema) {
  const auto outcome = run_percuss({"model", "rigid", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("model-rigid")), testing::IsEmpty());
  EXPECT_NEAR(document["best"]["z_m"].get<double>(), 0.1335, 0.5e-4);
  EXPECT_EQ(document["curve"].back()["z_m"], 0.42);
}

// At the default swing rate of 60 rad/s, the centre of mass moves at 30 m/s when the pivot is 0.5 m away.
TEST(ModelRigidCommand, TurnsAboutThePivot) {
  const auto about = run_percuss({"model", "rigid", "--pivot", "0.5", "--json"});
  const auto moving = run_percuss({"model", "rigid", "--bat-speed", "30", "--json"});
  EXPECT_EQ(about.out, moving.out);
}

TEST(ModelRigidCommand, WritesTableAndPicture) {
  const test::ScratchFolder folder;
  const auto outcome =
      run_percuss({"model", "rigid", "--at", "0:0.1:0.3", "-o", "a.csv", "-o", "a.svg"}, {.folder = folder.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto lines = test::lines_of(test::bytes_of(folder.file("a.csv")));
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[0], "z_m,exit_speed_mps,swing_speed_mps,effective_mass_kg");
  EXPECT_THAT(test::bytes_of(folder.file("a.svg")), testing::StartsWith("<svg "));
}

TEST(ModelRigidCommand, NamesTheInvalidOption) {
  for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{{"--ball-mass", "-1"},
                                                                                      {"--bat-mass", "0"},
                                                                                      {"--inertia", "nan"},
                                                                                      {"--length", "0"},
                                                                                      {"--swing-rate", "inf"},
                                                                                      {"--cor", "1.5"},
                                                                                      {"--cor", "nan"},
                                                                                      {"--at", "3:0:4"}}) {
    const auto outcome = run_percuss({"model", "rigid", option, value});
    EXPECT_EQ(outcome.code, 2) << option;
    EXPECT_THAT(outcome.err, HasSubstr("percuss: " + option + " "));
    EXPECT_EQ(test::lines_of(outcome.err).size(), 1U) << outcome.err;
  }
}

TEST(ModelCommand, RefusesAMissingOrUnknownModel) {
  EXPECT_EQ(run_percuss({"model"}).code, 2);
  const auto outcome = run_percuss({"model", "fly"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("there is no command 'model fly'; percuss model --help lists the commands"));
}

}  // namespace percuss::model_rigid_command_test
