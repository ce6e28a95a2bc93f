#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "support/files/csv_columns.hpp"
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
            "z_m,deflection_m_0_s,deflection_m_0.001_s,deflection_m_0.002_s,exit_speed_mps,rigid_exit_speed_mps,"
            "ball_share,vibration_share,mode_share_1,mode_share_2,mode_share_3,mode_share_4,mode_share_5,mode_share_6,"
            "mode_share_7,mode_share_8,effective_mass_kg");
}

nlohmann::json document_of(const test::ProcessOutcome& outcome) {
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  auto document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("model-bat")), testing::IsEmpty());
  return document;
}

// Each row of the wave's table holds the exit speed of an impact at its position, equal to the curve's.
TEST_F(ModelBatCommand, PutsExitSpeedsBesideTheWave) {
  const auto curve = document_of(run({"--modes", "10", "--at", "0.4:0.1:0.5", "--json"}))["curve"];
  ASSERT_EQ(run({"--modes", "10", "--wave", "0.6", "--wave-times", "0:0.001:0.002", "-o", "w.csv"}).code, 0);
  auto wave = test::csv_columns(folder_.file("w.csv"));
  const auto at = std::find(wave["z_m"].begin(), wave["z_m"].end(), 0.4);  // the end of a slice is an element's node
  ASSERT_NE(at, wave["z_m"].end());
  const auto row = static_cast<std::size_t>(at - wave["z_m"].begin());
  for (const char* name :
       {"exit_speed_mps", "rigid_exit_speed_mps", "ball_share", "vibration_share", "effective_mass_kg"})
    EXPECT_NEAR(wave[name][row], curve[0][name].get<double>(), 1e-9) << name;
  for (std::size_t m = 0; m < 8; ++m)
    EXPECT_NEAR(wave["mode_share_" + std::to_string(m + 1)][row], curve[0]["mode_share"][m].get<double>(), 1e-9) << m;
}

// A free bat: 1/(1/M + z²/I), with z from its centre of mass and I about it. A bat on a pin: I/d², with d from the pin
// and I about it. A clamped bat: null at every position.
TEST_F(ModelBatCommand, StatesTheEffectiveMassOfTheRigidBat) {
  constexpr double kPin_m = 0.1524;
  const auto with = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--modes", "4", "--at", "0.2:0.2:0.8", "--json"});
    return document_of(run(std::move(options)));
  };
  const auto free = with({}), pinned = with({"--support", "pinned"}), clamped = with({"--support", "clamped"});
  const double mass_kg = free["mass_kg"], cm_m = free["cm_m"], inertia_kgm2 = free["inertia_kgm2"];
  for (std::size_t i = 0; i < 4; ++i) {
    const double z_m = free["curve"][i]["z_m"], arm_m = z_m - cm_m, lever_m = z_m - kPin_m;
    EXPECT_NEAR(free["curve"][i]["effective_mass_kg"].get<double>(), 1 / (1 / mass_kg + arm_m * arm_m / inertia_kgm2),
                1e-9);
    const double about_pin_kgm2 = inertia_kgm2 + mass_kg * std::pow(cm_m - kPin_m, 2);
    EXPECT_NEAR(pinned["curve"][i]["effective_mass_kg"].get<double>() * lever_m * lever_m / about_pin_kgm2, 1, 1e-9);
    EXPECT_TRUE(clamped["curve"][i]["effective_mass_kg"].is_null());
  }
}

TEST_F(ModelBatCommand, ListsTheParticipationOfModes) {
  ASSERT_EQ(run({"--modes", "10", "--at", "0.5:0.1:0.8", "-o", "a.csv"}).code, 0);
  EXPECT_THAT(
      test::lines_of(test::bytes_of(folder_.file("a.csv")))[0],
      testing::EndsWith("ball_share,vibration_share,mode_share_1,mode_share_2,mode_share_3,mode_share_4,mode_share_5,"
                        "mode_share_6,mode_share_7,mode_share_8,effective_mass_kg"));
  EXPECT_THAT(run({"--modes", "10"}).out, HasSubstr("bending 4  other modes"));
}

// Long slices: both meanings of the rows are computed. The document states the frequencies of the other meaning too.
TEST_F(ModelBatCommand, SaysWhatTheRowsMean) {
  const auto slices = document_of(run({"--modes", "3", "--json"}));
  const auto points = document_of(run({"--modes", "3", "--profile-kind", "points", "--json"}));
  EXPECT_EQ(slices["profile"]["kind"], "slices");
  EXPECT_EQ(points["profile"]["kind"], "points");
  EXPECT_EQ(slices["profile"]["other_kind"]["frequency_hz"], points["frequency_hz"]);
  EXPECT_EQ(points["profile"]["other_kind"]["frequency_hz"], slices["frequency_hz"]);
  EXPECT_EQ(slices["warnings"][0]["code"], "long_slices");
  EXPECT_TRUE(points["warnings"].empty());
  EXPECT_THAT(run({"--modes", "3"}).out, HasSubstr("4 slices (constant between the positions), free"));
  EXPECT_THAT(run({"--modes", "3"}).out, HasSubstr("(--profile-kind)"));
  EXPECT_THAT(run({"--modes", "3", "--profile-kind", "points"}).out, HasSubstr("4 points (linear between"));
}

// Young's modulus of aluminium beside the default shear modulus, that of wood.
TEST_F(ModelBatCommand, WarnsOfAShearModulusOfAnotherMaterial) {
  const std::vector<std::string> points{"--modes", "3", "--profile-kind", "points", "--json", "--young", "70e9"};
  const auto warned = document_of(run(points));
  ASSERT_EQ(warned["warnings"].size(), 1U);
  EXPECT_EQ(warned["warnings"][0]["code"], "low_shear");
  EXPECT_NEAR(warned["warnings"][0]["value"].get<double>(), 70e9 / 1.05e9, 1e-6);
  std::vector<std::string> with_shear = points;
  with_shear.insert(with_shear.end(), {"--shear", "23.4e9"});
  EXPECT_TRUE(document_of(run(with_shear))["warnings"].empty());
}

TEST_F(ModelBatCommand, HasNoSecondMeaningForShortSlices) {
  std::string text;
  for (int i = 1; i <= 84; ++i) text += std::to_string(i) + "," + std::to_string(30 + 0.4 * i) + "\n";
  test::write_bytes(folder_.file("bat.csv"), text);
  const auto document = document_of(run({"--modes", "3", "--json"}));
  EXPECT_TRUE(document["profile"]["other_kind"].is_null());
  EXPECT_TRUE(document["warnings"].empty());
}

// The bat of beam_structure_test.cpp, whose frequencies come from the integrated differential equations.
constexpr const char* kHollow = "position,diameter,wall\n0,28,3\n35,28,3\n60,62,2.5\n84,66,2.5\n";

TEST_F(ModelBatCommand, ReadsHollowHeldAndLoadedBats) {
  test::write_bytes(folder_.file("bat.csv"), kHollow);
  const std::vector<std::string> bat{"--profile-kind", "points",     "--young", "7e10",       "--density",
                                     "2700",           "--shear",    "1.3e10",  "--add-mass", "0.05:0.84",
                                     "--add-mass",     "0.03:0:0.3", "--modes", "5",          "--json"};
  const auto held = [&](std::vector<std::string> more) {
    more.insert(more.end(), bat.begin(), bat.end());
    return document_of(run(more));
  };
  const auto free = held({});
  EXPECT_NEAR(free["frequency_hz"][0].get<double>(), 252.1725503, 0.001);
  EXPECT_NEAR(free["mass_kg"].get<double>(), 0.8589932413749422, 1e-9);
  EXPECT_EQ(free["support"]["kind"], "free");
  EXPECT_EQ(free["added_mass"].size(), 2U);
  const auto spring = held({"--support", "torsion", "--torsion", "1500"});
  EXPECT_NEAR(spring["frequency_hz"][1].get<double>(), 258.0186204, 0.001);
  EXPECT_DOUBLE_EQ(spring["support"]["at_m"].get<double>(), 0.1524);
  EXPECT_NEAR(held({"--support", "pinned"})["frequency_hz"][0].get<double>(), 244.6183874, 0.001);
  EXPECT_NEAR(held({"--support", "clamped"})["frequency_hz"][0].get<double>(), 37.09876125, 0.001);
}

// Two layers in the table: a shell and its core.
TEST_F(ModelBatCommand, ReadsLayersFromNamedColumns) {
  test::write_bytes(folder_.file("bat.csv"),
                    "end,diameter,wall,young,shear,density,wall_2,young_2,shear_2,density_2\n"
                    "84,66,3,7e10,1.3e10,2700,63,1e9,3e8,300\n");
  const auto layered = document_of(run({"--modes", "2", "--json"}));
  EXPECT_EQ(layered["profile"]["layers"], 2);
  constexpr double kQuarterPi = std::numbers::pi / 4;
  const double shell_kg = 2700 * kQuarterPi * (0.066 * 0.066 - 0.060 * 0.060) * 0.84;
  const double core_kg = 300 * kQuarterPi * 0.060 * 0.060 * 0.84;
  EXPECT_NEAR(layered["mass_kg"].get<double>(), shell_kg + core_kg, 1e-12);
}

TEST_F(ModelBatCommand, FitsConstantsToMeasuredFrequencies) {
  const auto truth = document_of(run({"--young", "1.5e10", "--total-mass", "0.9", "--modes", "3", "--json"}));
  std::string measured;
  for (const auto& f : truth["frequency_hz"]) measured += (measured.empty() ? "" : ",") + f.dump();
  const auto fit = document_of(
      run({"--total-mass", "0.9", "--fit", "young", "--measured", measured, "--measured-std", "0.1", "--json"}));
  EXPECT_NEAR(fit["material"]["young_pa"].get<double>(), 1.5e10, 1e4);
  EXPECT_NEAR(fit["mass_kg"].get<double>(), 0.9, 1e-12);
  EXPECT_EQ(fit["fit"]["parameters"][0]["name"], "young_pa");
  EXPECT_GT(fit["fit"]["parameters"][0]["std"].get<double>(), 0);
  EXPECT_THAT(run({"--fit", "young", "--measured", measured}).out, HasSubstr("fitted: Young's modulus"));
}

TEST_F(ModelBatCommand, RefusesContradictions) {
  using Words = std::vector<std::string>;
  for (const Words& words : std::vector<Words>{{"--total-mass", "0.9", "--density", "600"},
                                               {"--add-mass", "0.1:2"},
                                               {"--add-mass", "0.1:0.5:0.4"},
                                               {"--add-mass", "0:0.5"},
                                               {"--torsion", "100"},
                                               {"--support-at", "0.1"},
                                               {"--support-at", "2", "--support", "pinned"},
                                               {"--swing-rate", "10", "--support", "clamped"},
                                               {"--bat-speed", "10", "--support", "pinned"},
                                               {"--fit", "torsion", "--measured", "160"},
                                               {"--fit", "young"},
                                               {"--measured", "160"},
                                               {"--profile-kind", "lines"}}) {
    const auto outcome = run(words);
    EXPECT_EQ(outcome.code, 2) << testing::PrintToString(words) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(words[0]));
    EXPECT_EQ(test::lines_of(outcome.err).size(), 1U) << outcome.err;
  }
}

TEST_F(ModelBatCommand, NamesTheInvalidColumn) {
  for (const auto& [text, named] :
       std::vector<std::pair<std::string, std::string>>{{"2,50,1\n4,40,1\n", "column 3 has no name"},
                                                        {"end,diameter,mass\n2,50,1\n", "'mass'"},
                                                        {"end,diameter,diameter\n2,50,1\n", "repeats"},
                                                        {"end,diameter,thickness\n2,50,1\n", "walls"},
                                                        {"end,diameter,young_2\n2,50,1e9\n", "layer 1 has no wall"},
                                                        {"end,width,young\n2,50,1e9\n", "layer 1 has no thickness"},
                                                        {"end,diameter,density (g/cm³)\n2,50,0.7\n", "g/cm³"},
                                                        {"end,diameter,young (psi)\n2,50,1e6\n", "psi"},
                                                        {"end,diameter,wall (kg)\n2,50,1\n", "kg"},
                                                        {"end,diameter,wall,diameter_2\n2,50,1,40\n", "'diameter_2'"},
                                                        {"end,diameter\n0,50\n2,50\n", "ends at position 0"},
                                                        {"end,diameter,wall\n2,50,0\n", "wall"},
                                                        {"end,diameter,young\n2,50,-1\n", "Young"},
                                                        {"end (mm),diameter (mm),wall\n2,50,1\n", "mm"}}) {
    test::write_bytes(folder_.file("bat.csv"), text);
    const auto outcome = run({});
    EXPECT_EQ(outcome.code, 3) << text << outcome.out;
    EXPECT_THAT(outcome.err, HasSubstr(named)) << text;
    EXPECT_EQ(test::lines_of(outcome.err).size(), 1U) << outcome.err;
  }
}

TEST_F(ModelBatCommand, NamesTheUnitsOfTheProfileOnlyWhereTheyMayBeWrong) {
  for (const std::string text :
       {"end,diameter,young (psi)\n2,50,1e6\n", "2,50000\n", "2,50\n4000,40\n", "end,diameter,wall\n2,50,5000\n"}) {
    test::write_bytes(folder_.file("bat.csv"), text);
    EXPECT_THAT(run({}).err, HasSubstr("(--profile-unit)")) << text;
  }
  for (const std::string text : {"end,diameter,thickness\n2,50,1\n", "end,diameter,young_2\n2,50,1e9\n",
                                 "end,young\n2,1e9\n", "end,diameter,young\n2,50,-1\n", "2,50\n1,40\n"}) {
    test::write_bytes(folder_.file("bat.csv"), text);
    const auto outcome = run({});
    EXPECT_EQ(outcome.code, 3) << text;
    EXPECT_THAT(outcome.err, testing::Not(HasSubstr("--profile-unit"))) << text;
  }
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
