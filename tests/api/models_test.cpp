#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "percuss/metrics.hpp"
#include "percuss/models.hpp"
#include "support/json.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// The public models and the performance of a bat give the numbers of the documents that the command line prints.
namespace percuss::api_models_test {

nlohmann::json document_of(std::vector<std::string> arguments) {
  arguments.emplace_back("--json");
  const test::ProcessOutcome outcome = test::run_percuss(arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return test::parse_json(outcome.out);
}

TEST(PublicModels, BeamAgreesWithTheCommandLine) {
  const auto document = document_of({"model", "beam", "--support", "free", "--length", "0.84", "--modes", "4"});
  const std::vector<BeamMode> modes = beam_modes({.support = BeamSupport::free, .length_m = 0.84}, {.modes = 4});
  ASSERT_EQ(modes.size(), document["frequency_hz"].size());
  for (std::size_t m = 0; m < modes.size(); ++m) {
    EXPECT_EQ(modes[m].freq_Hz, document["frequency_hz"][m]);
    EXPECT_EQ(modes[m].node_m, document["node_m"][m].get<std::vector<double>>());
  }
}

TEST(PublicModels, ImpactAgreesWithTheCommandLine) {
  const auto document = document_of({"model", "impact", "--at", "0.5", "--speed", "6"});
  const BeamImpactResult result = beam_impact({.at_m = 0.5, .speed_mps = 6});
  EXPECT_EQ(result.cor, document["cor"]);
  EXPECT_EQ(result.peak_force_N, document["peak_force_n"]);
}

TEST(PublicModels, ImpactRefusesABeamWithShear) {
  EXPECT_THROW(beam_impact({.beam = {.shear_stiffness_N = 1e5}}), InputError);
  EXPECT_THROW(beam_impact({.beam = {.gyration_m = 0.01}}), InputError);
}

TEST(PublicModels, RigidBatAndTrampolineAgreeWithTheCommandLine) {
  const auto rigid = document_of({"model", "rigid", "--cor", "0.5"});
  const auto& at = rigid["curve"][3];
  EXPECT_EQ(exit_speed_mps({.cor = 0.5}, at["z_m"]), at["exit_speed_mps"]);
  EXPECT_EQ(effective_mass_kg({.cor = 0.5}, at["z_m"]), at["effective_mass_kg"]);
  const auto trampoline = document_of({"model", "trampoline", "--ball", "baseball", "--hoop", "1000:500:2000"});
  EXPECT_EQ(rigid_wall_rebound({}).cor, trampoline["wall_cor"]);
  EXPECT_EQ(trampoline_rebound({}, 1500).cor, trampoline["curve"][1]["cor"]);
}

TEST(PublicModels, BatAndShellAgreeWithTheCommandLine) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("profile.txt"), "0.02 0.05\n0.4 0.026\n0.84 0.066\n");
  const BatProfile profile{.end_m = {0.02, 0.4, 0.84}, .diameter_m = {0.05, 0.026, 0.066}};
  const auto bat = document_of({"model", "bat", "--profile", folder.file("profile.txt"), "--modes", "6"});
  const BatModes modes = bat_modes(profile, 6);
  EXPECT_EQ(modes.freq_Hz, bat["frequency_hz"].get<std::vector<double>>());
  EXPECT_EQ(modes.cm_m, bat["cm_m"]);
  const auto& at = bat["curve"][2];
  EXPECT_EQ(bat_exit_speeds_mps(profile, {at["z_m"]}, {.modes = 6})[0], at["exit_speed_mps"]);
  const auto shell = document_of({"model", "shell"});
  EXPECT_EQ(hoop_Hz({}, 2, 1), shell["flugge_hz"][0]);
  EXPECT_EQ(long_hoop_Hz({}, 2), shell["rayleigh_hz"]);
}

TEST(PublicModels, HollowHeldAndLoadedBatsAgreeWithTheCommandLine) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("bat.csv"), "x,diameter,wall\n0,0.028,0.003\n0.4,0.03,0.003\n0.84,0.066,0.0025\n");
  const BatProfile profile{.end_m = {0, 0.4, 0.84},
                           .diameter_m = {0.028, 0.03, 0.066},
                           .wall_m = {0.003, 0.003, 0.0025},
                           .points = true,
                           .added = {{.mass_kg = 0.03, .from_m = 0, .to_m = 0.25}},
                           .support = BeamSupport::torsion,
                           .torsion_Nmprad = 900};
  const auto bat =
      document_of({"model", "bat", "--profile", folder.file("bat.csv"), "--profile-kind", "points", "--add-mass",
                   "0.03:0:0.25", "--support", "torsion", "--torsion", "900", "--modes", "6"});
  EXPECT_EQ(bat_modes(profile, 6).freq_Hz, bat["frequency_hz"].get<std::vector<double>>());
  const auto& at = bat["curve"][40];
  EXPECT_EQ(bat_exit_speeds_mps(profile, {at["z_m"]}, {.modes = 6})[0], at["exit_speed_mps"]);
}

TEST(PublicModels, BatRefusesMassesAndSupportsOffTheBatAndListsOfAnotherLength) {
  const BatProfile plain{.end_m = {0.84}, .diameter_m = {0.05}};
  BatProfile wrong = plain;
  wrong.added = {{.mass_kg = 0.03, .from_m = 0.5, .to_m = 0.9}};
  EXPECT_THROW(bat_modes(wrong), InputError);
  wrong = plain;
  wrong.support = BeamSupport::pinned;
  wrong.support_m = 1;
  EXPECT_THROW(bat_modes(wrong), InputError);
  wrong = plain;
  wrong.wall_m = {0.003, 0.003};
  EXPECT_THROW(bat_modes(wrong), InputError);
}

TEST(PublicModels, ImpactFollowsTheBallToItsLastContact) {
  const auto document = document_of({"model", "impact", "--rho-a", "0.8"});
  const BeamImpactResult result = beam_impact({.beam = {.rho_a_kgpm = 0.8}});
  EXPECT_EQ(*result.final_cor, document["final_cor"]);
  EXPECT_EQ(result.contacts, document["contacts"]);
}

TEST(PublicMetrics, AgreeWithTheCommandLine) {
  constexpr double kInch = 0.0254, kOunce = 0.028349523125, kMph = 0.44704;
  const auto document =
      document_of({"metrics", "--length-in", "34", "--weight-oz", "31", "--cg-in", "20", "--period-s", "1.25",
                   "--ball-g", "145.4", "--z-in", "6", "--v-in-mph", "136", "--v-out-mph", "31"});
  const BatPerformance bat = bat_performance({.length_m = Measured{34 * kInch},
                                              .mass_kg = Measured{31 * kOunce},
                                              .cg_m = Measured{20 * kInch},
                                              .period_s = Measured{1.25},
                                              .ball_kg = Measured{0.1454},
                                              .z_m = Measured{6 * kInch},
                                              .v_in_mps = Measured{136 * kMph},
                                              .v_out_mps = Measured{31 * kMph}});
  EXPECT_DOUBLE_EQ(bat.drop->value, document["drop"]);
  EXPECT_DOUBLE_EQ(bat.besr->value, document["besr"]);
  EXPECT_DOUBLE_EQ(bat.bbcor->value, document["bbcor"]);
  EXPECT_DOUBLE_EQ(bat.bbs_mps->value / kMph, document["bbs_mph"]);
}

}  // namespace percuss::api_models_test
