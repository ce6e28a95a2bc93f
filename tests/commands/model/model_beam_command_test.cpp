#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/rejection.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::model_beam_command_test {

using test::run_percuss;
using testing::HasSubstr;
using testing::IsEmpty;

nlohmann::json document(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"model", "beam", "--json"});
  const auto outcome = run_percuss(arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  auto out = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(out, test::schema_named("model-beam")), IsEmpty());
  return out;
}

TEST(ModelBeamCommand, PrintsADocumentThatFitsItsSchema) {
  const auto all = document({});
  ASSERT_EQ(all["frequency_hz"].size(), 10U);
  EXPECT_NEAR(all["frequency_hz"][1].get<double>(), 322.433, 0.5e-3);
  EXPECT_EQ(all["node_m"][3].size(), 3U);
  EXPECT_TRUE(all["fit"].is_null());
}

TEST(ModelBeamCommand, ListsRigidBodyModesAtZero) {
  const auto pinned = document({"--support", "pinned", "--modes", "2"});
  EXPECT_EQ(pinned["frequency_hz"][0], 0);
  EXPECT_NEAR(pinned["lambda"][1].get<double>(), 3.9266023, 1e-7);
  const auto free = document({"--support", "free", "--modes", "3"});
  EXPECT_EQ(free["frequency_hz"][1], 0);
  EXPECT_NEAR(free["lambda"][2].get<double>(), 4.7300407, 1e-7);
  EXPECT_TRUE(free["beam"]["torsion_nmprad"].is_null());
}

TEST(ModelBeamCommand, AcceptsShearRotaryInertiaAndLayers) {
  const auto stubby =
      document({"--support", "free", "--gyration", "0.05", "--shear-stiffness", "2e6", "--modes", "3", "--ei", "4000"});
  EXPECT_NEAR(stubby["frequency_hz"][2].get<double>(), 386.1276095, 1e-6);
  const auto layers = document({"--layer", "7e10:0.1:0.002:2700", "--layer", "7e10:0.1:0.008:2700"});
  EXPECT_NEAR(layers["beam"]["ei_nm2"].get<double>(), 7e10 * 0.1 * 1e-6 / 12, 1e-9);
  EXPECT_NEAR(layers["beam"]["rho_a_kgpm"].get<double>(), 2.7, 1e-12);
}

TEST(ModelBeamCommand, FitsMeasuredFrequencies) {
  const auto fit = document({"--fit", "ei,torsion", "--measured", "14.536,322.433,1037.79", "--measured-std", "0.01"});
  ASSERT_EQ(fit["fit"]["parameters"].size(), 2U);
  EXPECT_NEAR(fit["fit"]["parameters"][0]["value"].get<double>(), 4000, 1);
  EXPECT_NEAR(fit["fit"]["parameters"][1]["value"].get<double>(), 1200, 1);
  EXPECT_GT(fit["fit"]["parameters"][1]["std"].get<double>(), 0);
  EXPECT_EQ(fit["beam"]["ei_nm2"], fit["fit"]["parameters"][0]["value"]);
  const auto free =
      document({"--support", "free", "--fit", "rho-a", "--measured", "1276.645", "--measured-modes", "3"});
  EXPECT_NEAR(free["fit"]["parameters"][0]["value"].get<double>(), 2.24, 1e-5);
  EXPECT_TRUE(free["fit"]["parameters"][0]["std"].is_null());
}

// The second frequency is 2 % too high: 650 of its standard deviations.
TEST(ModelBeamCommand, SaysThatAMisfitEnlargesTheStandardDeviations) {
  const std::vector<std::string> words{"--fit", "ei", "--measured", "14.536,328.9,1037.79", "--measured-std", "0.01"};
  const auto fit = document(words)["fit"];
  EXPECT_GT(fit["birge_ratio"].get<double>(), 100);
  std::vector<std::string> printed{"model", "beam"};
  printed.insert(printed.end(), words.begin(), words.end());
  EXPECT_THAT(run_percuss(printed).out, HasSubstr("misfit beyond the ± of the frequencies"));
  const auto good = document({"--fit", "ei", "--measured", "14.536,322.433,1037.79", "--measured-std", "0.01"})["fit"];
  EXPECT_EQ(good["birge_ratio"], 1);
  EXPECT_LT(good["parameters"][0]["std"].get<double>(), 0.01 * fit["parameters"][0]["std"].get<double>());
}

// The frequencies are those of the beam with EI 4000, spring 1200 and ρA 2.24. Each start is far from these values.
TEST(ModelBeamCommand, TakesAGivenValueOfAFittedParameterForItsStart) {
  const std::vector<std::string> measured{"--measured", "14.536,322.433,1037.79", "--measured-std", "0.01"};
  const auto fitted = [&](std::vector<std::string> words) {
    words.insert(words.end(), measured.begin(), measured.end());
    return document(words)["fit"]["parameters"];
  };
  EXPECT_NEAR(fitted({"--fit", "ei", "--ei", "35"})[0]["value"].get<double>(), 4000, 1);
  EXPECT_NEAR(fitted({"--fit", "torsion", "--torsion", "9000"})[0]["value"].get<double>(), 1200, 1);
  EXPECT_NEAR(fitted({"--fit", "torsion", "--torsion", "0"})[0]["value"].get<double>(), 1200, 1);
  EXPECT_NEAR(fitted({"--fit", "rho-a", "--rho-a", "90"})[0]["value"].get<double>(), 2.24, 1e-3);
  const auto both = fitted({"--fit", "ei,torsion", "--ei", "70", "--torsion", "4e4"});
  EXPECT_NEAR(both[0]["value"].get<double>(), 4000, 1);
  EXPECT_NEAR(both[1]["value"].get<double>(), 1200, 1);
  EXPECT_NEAR(fitted({"--fit", "ei", "--layer", "7e10:0.1:0.002"})[0]["value"].get<double>(), 4000, 1);
  // A spring without stiffness is a pin: its first mode is a rigid-body mode.
  const auto pinned = document({"--torsion", "0", "--fit", "ei", "--measured", "319.1605"});
  EXPECT_NEAR(pinned["fit"]["parameters"][0]["value"].get<double>(), 4000, 1);
}

TEST(ModelBeamCommand, ComputesTheSpringFromStaticReadings) {
  // 10 N and 20 N at 0.5 m: P a²/T + P a³/(3 EI) with T = 1200, EI = 4000.
  const auto fit = document({"--static", "10:0.5:0.0021875", "--static", "20:0.5:0.004375"});
  EXPECT_NEAR(fit["beam"]["torsion_nmprad"].get<double>(), 1200, 1e-6);
}

TEST(ModelBeamCommand, WritesShapesAsTableAndPicture) {
  const test::ScratchFolder folder;
  const auto outcome = run_percuss({"model", "beam", "--modes", "3", "-o", "a.csv", "-o", "a.svg", "-o", "a.json"},
                                   {.folder = folder.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto lines = test::lines_of(test::bytes_of(folder.file("a.csv")));
  ASSERT_EQ(lines.size(), 202U);
  EXPECT_EQ(lines[0], "x_m,mode_0,mode_1,mode_2");
  EXPECT_THAT(test::bytes_of(folder.file("a.svg")), testing::StartsWith("<svg "));
}

TEST(ModelBeamCommand, NamesTheInvalidOption) {
  using Words = std::vector<std::string>;
  for (const Words& words : std::vector<Words>{{"--length", "0"},
                                               {"--ei", "-4000"},
                                               {"--rho-a", "nan"},
                                               {"--torsion", "inf"},
                                               {"--torsion", "-1"},
                                               {"--torsion", "5", "--support", "free"},
                                               {"--support", "glued"},
                                               {"--modes", "0"},
                                               {"--modes", "-1"},
                                               {"--modes", "100000000"},
                                               {"--gyration", "0"},
                                               {"--shear-stiffness", "x"},
                                               {"--layer", "1:2"},
                                               {"--layer", "1:2:nan"},
                                               {"--layer", "1:2:3:4:5"},
                                               {"--layer", "7e10:0.1:0.01", "--ei", "5"},
                                               {"--fit", "ei,torsion,rho-a", "--measured", "1,2,3"},
                                               {"--fit", "ei,rho-a", "--measured", "1,2", "--support", "clamped"},
                                               {"--fit", "torsion", "--measured", "1,2", "--support", "free"},
                                               {"--fit", "mass", "--measured", "1"},
                                               {"--fit", "torsion", "--static", "10:0.5:0.002", "--measured", "14"},
                                               {"--fit", "ei,torsion", "--measured", "1"},
                                               {"--fit", "ei"},
                                               {"--measured", "100"},
                                               {"--measured", "100,50", "--fit", "ei"},
                                               {"--measured", "nan", "--fit", "ei"},
                                               {"--measured-std", "0", "--measured", "9", "--fit", "ei"},
                                               {"--measured-modes", "1,2", "--measured", "9", "--fit", "ei"},
                                               {"--static", "10:0.5"},
                                               {"--static", "10:0.9:0.001"},
                                               {"--static", "10:0.5:0.002", "--torsion", "5"}}) {
    Words arguments{"model", "beam"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    test::expect_usage_error(arguments, words[0]);
  }
}

TEST(ModelBeamCommand, TakesTwoColumnsWithoutNamesAsPositionAndDiameter) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("named.csv"), "position,diameter\n0,0.03\n0.3,0.03\n0.6,0.02\n");
  test::write_bytes(folder.file("bare.csv"), "0,0.03\n0.3,0.03\n0.6,0.02\n");
  std::vector<std::string> tables;
  for (const char* name : {"named.csv", "bare.csv"}) {
    const auto outcome = test::run_percuss(
        {"model", "beam", "--profile", folder.file(name), "--young", "1e10", "--density", "600", "--support", "free"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    tables.push_back(outcome.out);
  }
  EXPECT_EQ(tables[0], tables[1]);
}

// The uniform beam as a table of its section, and a fit of its stiffness and spring.
TEST(ModelBeamCommand, ReadsATableOfSections) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("beam.csv"), "x,width,thickness\n0,0.1,0.02\n0.3,0.1,0.02\n0.57,0.1,0.02\n");
  const auto document_of = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"model",     "beam", "--profile", folder.file("beam.csv"),
                                   "--density", "1120", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    const auto outcome = test::run_percuss(words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    auto document = test::parse_json(outcome.out);
    EXPECT_THAT(test::schema_violations(document, test::schema_named("model-beam")), testing::IsEmpty());
    return document;
  };
  // The stiffness 12 EI/l³ of each of the 200 elements is 5·10⁸ times the spring's T/L², so rounding changes the lowest
  // frequency by 10⁻⁶ of its value.
  constexpr double kRounded = 2e-6;
  for (const char* support : {"torsion", "pinned", "clamped", "free"}) {
    const auto shaped = document_of({"--young", "6e10", "--support", support, "--modes", "5"});
    const auto outcome = test::run_percuss({"model", "beam", "--support", support, "--modes", "5", "--json"});
    const auto uniform = test::parse_json(outcome.out);
    for (std::size_t i = 0; i < 5; ++i) {
      const double f_Hz = uniform["frequency_hz"][i].get<double>();
      EXPECT_NEAR(shaped["frequency_hz"][i].get<double>(), f_Hz, kRounded * f_Hz) << support << i;
      ASSERT_EQ(shaped["node_m"][i].size(), uniform["node_m"][i].size()) << support << i;
      for (std::size_t n = 0; n < shaped["node_m"][i].size(); ++n)
        EXPECT_NEAR(shaped["node_m"][i][n].get<double>(), uniform["node_m"][i][n].get<double>(), 1e-6);
    }
    EXPECT_TRUE(shaped["lambda"][0].is_null());
  }
  const auto fit = document_of(
      {"--young", "3e10", "--fit", "young,torsion", "--measured", "14.536,322.433,1037.79", "--measured-std", "0.01"});
  EXPECT_NEAR(fit["material"]["young_pa"].get<double>(), 6e10, 6e10 * 1e-4);
  EXPECT_NEAR(fit["support"]["torsion_nmprad"].get<double>(), 1200, 1);
  EXPECT_EQ(test::run_percuss({"model", "beam", "--fit", "young", "--measured", "14"}).code, 2);
}

}  // namespace percuss::model_beam_command_test
