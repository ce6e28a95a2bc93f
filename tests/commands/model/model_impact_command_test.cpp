#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/files/csv_columns.hpp"
#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/rejection.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::model_impact_command_test {

using test::run_percuss;
using testing::HasSubstr;
using testing::IsEmpty;

nlohmann::json document(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"model", "impact", "--json"});
  const auto outcome = run_percuss(arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  auto out = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(out, test::schema_named("model-impact")), IsEmpty());
  return out;
}

TEST(ModelImpactCommand, PrintsADocumentThatFitsItsSchema) {
  const auto all = document({});
  EXPECT_NEAR(all["cor"].get<double>(), 0.4699495, 1e-6);  // impact_test.cpp states the source
  EXPECT_EQ(all["recontact"], false);
  EXPECT_EQ(all["frequency_hz"].size(), 10U);
  EXPECT_FALSE(all.contains("sweep"));
}

TEST(ModelImpactCommand, SweepsEachOfItsParameters) {
  const auto all = document({"--sweep", "ei=1000:1000:6000", "--sweep", "torsion=500:500:3000", "--sweep",
                             "rho-a=0.6:0.2:3", "--sweep", "at=0.025:0.065:0.545", "--sweep", "speed=1:1:3"});
  const auto& sweep = all["sweep"];
  ASSERT_EQ(sweep.size(), 6U + 6U + 13U + 9U + 3U);
  EXPECT_EQ(sweep[3]["ei"], 4000);
  EXPECT_EQ(sweep[3]["cor"], all["cor"]);  // the default EI
  EXPECT_EQ(sweep[12]["rho_a"], 0.6);
  EXPECT_EQ(sweep[12]["recontact"], true);
  EXPECT_LT(sweep[12]["cor"].get<double>(), 0);
  EXPECT_EQ(sweep[25]["at"], 0.025);
}

// impact_test.cpp states the source of the figures.
TEST(ModelImpactCommand, ReportsTheReboundAfterTheLastContact) {
  const auto light = document({"--rho-a", "0.8"});
  EXPECT_EQ(light["recontact"], true);
  EXPECT_GT(light["contacts"].get<int>(), 1);
  EXPECT_NEAR(light["cor"].get<double>(), 0.0665, 1e-3);
  EXPECT_NEAR(light["final_cor"].get<double>(), 0.912, 1e-3);
  EXPECT_NEAR(light["final_ball_speed_mps"].get<double>(), -0.912 * 5, 5e-3);
  EXPECT_LT(light["final_cor_uncertainty"].get<double>(), 1e-6);
  EXPECT_THAT(run_percuss({"model", "impact", "--rho-a", "0.8"}).out, HasSubstr("the ball leaves for good after"));
  const auto heavy = document({});
  EXPECT_EQ(heavy["contacts"], 1);
  EXPECT_EQ(heavy["final_cor"], heavy["cor"]);
}

TEST(ModelImpactCommand, HasNoLargestDeflectionOfABeamThatFliesOff) {
  for (const char* support : {"free", "pinned"}) {
    const auto flying = document({"--support", support});
    EXPECT_EQ(flying["flies_off"], true);
    EXPECT_TRUE(flying["peak_deflection_m"].is_null());
    EXPECT_TRUE(flying["peak_deflection_time_s"].is_null());
    const auto text = run_percuss({"model", "impact", "--support", support}).out;
    EXPECT_THAT(text, HasSubstr("the beam flies off"));
    EXPECT_THAT(text, testing::Not(HasSubstr("largest deflection of")));
  }
  const auto held = document({"--support", "clamped"});
  EXPECT_EQ(held["flies_off"], false);
  EXPECT_GT(held["peak_deflection_m"].get<double>(), 0);
}

// The uniform beam as a table of its section: the same impact, up to the error of the elements.
TEST(ModelImpactCommand, StrikesABeamWithATableOfSections) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("beam.csv"), "x,width,thickness\n0,0.1,0.02\n0.57,0.1,0.02\n");
  const std::vector<std::string> table{"--profile", folder.file("beam.csv"), "--young", "6e10", "--density", "1120"};
  const std::vector<std::string> uniform{"--ei", "4000", "--rho-a", "2.24"};
  for (const char* support : {"torsion", "pinned", "clamped", "free"}) {
    std::vector<std::string> a{"--support", support}, b = a;
    a.insert(a.end(), table.begin(), table.end());
    b.insert(b.end(), uniform.begin(), uniform.end());
    const auto shaped = document(a), plain = document(b);
    EXPECT_NEAR(shaped["cor"].get<double>(), plain["cor"].get<double>(), 1e-5) << support;
    EXPECT_NEAR(shaped["peak_force_n"].get<double>(), plain["peak_force_n"].get<double>(), 0.01) << support;
    EXPECT_EQ(shaped["frequency_hz"].size(), 10U);
    EXPECT_EQ(shaped["profile"]["kind"], "points");
  }
  std::vector<std::string> sweep{"--sweep", "torsion=600:600:1200", "--sweep", "at=0.4:0.1:0.5",
                                 "--sweep", "speed=4:1:5"};
  auto a = sweep, b = sweep;
  a.insert(a.end(), table.begin(), table.end());
  b.insert(b.end(), uniform.begin(), uniform.end());
  const auto shaped = document(a)["sweep"], plain = document(b)["sweep"];
  ASSERT_EQ(shaped.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(shaped[i]["cor"].get<double>(), plain[i]["cor"].get<double>(), 1e-5) << i;
}

// The only mode moves the free beam as a rigid body, so there are no frequencies of slices and of points to compare.
TEST(ModelImpactCommand, DoesNotWarnOfTheProfileKindWithoutAnElasticMode) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("beam.csv"), "x,width,thickness\n0.3,0.1,0.02\n0.57,0.1,0.03\n");
  const auto found = document({"--profile", folder.file("beam.csv"), "--profile-kind", "slices", "--young", "6e10",
                               "--density", "1120", "--support", "free", "--modes", "1"});
  EXPECT_TRUE(found["warnings"].empty());
}

TEST(ModelImpactCommand, RefusesOptionsOfAUniformBeamBesideATable) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("beam.csv"), "0,0.1,0.02\n0.57,0.1,0.02\n");
  using Words = std::vector<std::string>;
  for (const Words& words : std::vector<Words>{{"--ei", "4000"},
                                               {"--rho-a", "2"},
                                               {"--length", "0.5"},
                                               {"--layer", "1e9:0.1:0.1"},
                                               {"--sweep", "ei=1000:1000:2000"},
                                               {"--at", "0.6"}}) {
    Words arguments{"model", "impact", "--profile", folder.file("beam.csv"), "--young", "1e10", "--density", "600"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    test::expect_usage_error(arguments, words[0]);
  }
  for (const Words& words : std::vector<Words>{{"--young", "1e10"}, {"--density", "600"}, {"--add-mass", "0.1:0.2"}}) {
    Words arguments{"model", "impact"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    EXPECT_EQ(run_percuss(arguments).code, 2) << words[0];
  }
  EXPECT_EQ(run_percuss({"model", "impact", "--profile", folder.file("beam.csv"), "--density", "600"}).code, 2);
}

// One sweep of positions gives the curve of deflection over position: in the table, and as a second picture.
TEST(ModelImpactCommand, DrawsDeflectionOverPosition) {
  const test::ScratchFolder folder;
  ASSERT_EQ(run_percuss({"model", "impact", "--sweep", "at=0.025:0.065:0.545", "-o", "a.svg", "-o", "a.csv"},
                        {.folder = folder.path()})
                .code,
            0);
  const std::string svg = test::bytes_of(folder.file("a.svg"));
  EXPECT_THAT(svg, HasSubstr("coefficient of restitution"));
  EXPECT_THAT(svg, HasSubstr("largest deflection, mm"));
  EXPECT_THAT(test::bytes_of(folder.file("a.csv")), HasSubstr("peak_deflection_m"));
}

TEST(ModelImpactCommand, GivesTheSameResultOnOneThread) {
  const std::vector<std::string> words{"model", "impact", "--sweep", "ei=1000:500:6000", "--json", "--threads"};
  auto one = words, four = words;
  one.emplace_back("1");
  four.emplace_back("4");
  EXPECT_EQ(run_percuss(one).out, run_percuss(four).out);
}

TEST(ModelImpactCommand, OffersTheMethodOfTheSourceAndALossyContact) {
  const auto classic = document({"--method", "small-increment", "--step", "1e-6"});
  EXPECT_NEAR(classic["cor"].get<double>(), 0.46995, 2e-3);
  EXPECT_TRUE(classic["cor_uncertainty"].is_null());
  const auto lossy = document({"--contact-cor", "0.6"});
  EXPECT_LT(lossy["cor"].get<double>(), 0.4);
  EXPECT_GT(lossy["lost_j"].get<double>(), 0);
}

TEST(ModelImpactCommand, WritesSeriesAndCurves) {
  const test::ScratchFolder folder;
  ASSERT_EQ(run_percuss({"model", "impact", "-o", "a.csv", "-o", "a.svg"}, {.folder = folder.path()}).code, 0);
  const auto series = test::lines_of(test::bytes_of(folder.file("a.csv")));
  EXPECT_EQ(series[0], "time_s,deflection_m,force_n,ball_speed_mps,ball_m");
  EXPECT_GT(series.size(), 4000U);
  ASSERT_EQ(run_percuss({"model", "impact", "--sweep", "at=0.1:0.1:0.5", "-o", "b.csv", "-o", "b.svg"},
                        {.folder = folder.path()})
                .code,
            0);
  const auto sweep = test::lines_of(test::bytes_of(folder.file("b.csv")));
  ASSERT_EQ(sweep.size(), 6U);
  EXPECT_THAT(sweep[1], testing::StartsWith("4000,1200,2.24,0.1,5,"));
  EXPECT_THAT(test::bytes_of(folder.file("b.svg")), HasSubstr("coefficient of restitution"));
}

// The largest value of each curve is the largest deflection that the sweep states.
TEST(ModelImpactCommand, WritesTheMotionOfEachImpactOfASweep) {
  const test::ScratchFolder folder;
  constexpr double kSampling = 1e-3;  // no sample of a curve lies exactly at its maximum
  const std::vector<std::string> words{"model",   "impact",        "--sweep", "at=0.025:0.13:0.545",
                                       "--sweep", "ei=3e3:1e3:4e3"};
  std::vector<std::string> curves = words, rows = words;
  curves.insert(curves.end(), {"--curves", "-o", "c.csv", "-o", "c.svg"});
  rows.insert(rows.end(), {"-o", "r.csv"});
  ASSERT_EQ(run_percuss(curves, {.folder = folder.path()}).code, 0);
  ASSERT_EQ(run_percuss(rows, {.folder = folder.path()}).code, 0);
  auto motion = test::csv_columns(folder.file("c.csv")), impact = test::csv_columns(folder.file("r.csv"));
  ASSERT_EQ(impact["at"].size(), 7U);
  for (std::size_t i = 0; i < impact["at"].size(); ++i) {
    double largest_m = 0;
    for (std::size_t row = 0; row < motion["at"].size(); ++row) {
      if (motion["at"][row] == impact["at"][i] && motion["ei"][row] == impact["ei"][i])
        largest_m = std::max(largest_m, std::abs(motion["deflection_m"][row]));
    }
    EXPECT_NEAR(largest_m / impact["peak_deflection_m"][i], 1, kSampling) << i;
  }
  EXPECT_THAT(test::bytes_of(folder.file("c.svg")),
              testing::AllOf(HasSubstr("Deflection of the struck point"), HasSubstr("at 0.545"), HasSubstr("ei 4000")));
  for (const auto& invalid :
       std::vector<std::vector<std::string>>{{"--curves"}, {"--curves", "--sweep", "at=0.1:0.001:0.4"}}) {
    std::vector<std::string> arguments{"model", "impact"};
    arguments.insert(arguments.end(), invalid.begin(), invalid.end());
    const auto outcome = run_percuss(arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--curves"));
  }
}

TEST(ModelImpactCommand, NamesTheInvalidOption) {
  using Words = std::vector<std::string>;
  for (const Words& words : std::vector<Words>{{"--ball-mass", "-0.1"},
                                               {"--speed", "0"},
                                               {"--hertz", "nan"},
                                               {"--at", "0.6"},
                                               {"--at", "-0.1"},
                                               {"--modes", "0"},
                                               {"--modes", "1000000"},
                                               {"--method", "euler"},
                                               {"--step", "0"},
                                               {"--step", "1e-15"},
                                               {"--step", "1"},
                                               {"--contact-cor", "1.1"},
                                               {"--contact-cor", "0"},
                                               {"--contact-cor", "nan"},
                                               {"--length", "0"},
                                               {"--sweep", "ei"},
                                               {"--sweep", "mass=1:1:2"},
                                               {"--sweep", "ei=0:1:5"},
                                               {"--sweep", "ei=1:1:nan"},
                                               {"--sweep", "at=0.1:0.1:0.9"},
                                               {"--sweep", "torsion=1:1:2", "--support", "free"}}) {
    Words arguments{"model", "impact"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    test::expect_usage_error(arguments, words[0]);
  }
}

}  // namespace percuss::model_impact_command_test
