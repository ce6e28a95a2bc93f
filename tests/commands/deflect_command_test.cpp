#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "acquire/formats/hdf5/write_hdf5.hpp"
#include "acquire/open_measurement.hpp"
#include "model/impact/ball_on_beam.hpp"
#include "support/changed_record.hpp"
#include "support/files/csv_columns.hpp"
#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/rejection.hpp"
#include "support/scratch_folder.hpp"

// percuss deflect, and percuss compare of its deflections with a model.
namespace percuss::deflect_command_test {

using nlohmann::json;
using test::run_percuss;
using testing::HasSubstr;

constexpr double kFs_Hz = 100000;
constexpr double kRest_s = 0.1, kLength_s = 0.18;  // the model follows the motion for 80 ms
constexpr double kSensorGain = 0.8;  // factor of a wrong calibration of the accelerometer; model/test is 1/0.8 = 1.25
const std::vector<double> kPlaces_m{0.155, 0.285, 0.415, 0.545};

/// The composite bat struck by a cricket ball: force and acceleration at the struck point, from the sum of its modes.
void add_impact(double at_m, std::mt19937& random, std::vector<double>& force_N, std::vector<double>& accel_mps2) {
  model::Impact impact;
  impact.at_m = at_m;
  model::BallOnBeam model(impact);
  model::BallOnBeamState state = model.start(impact.speed_mps);
  std::normal_distribution<double> gauss;
  constexpr int kSubsteps = 8;
  bool separated = false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(kLength_s * kFs_Hz); ++i) {
    double force = 0, accel = 0;
    if (static_cast<double>(i) >= kRest_s * kFs_Hz) {
      force = model.read(state).force_N;
      for (std::size_t m = 0; m < model.modes(); ++m) {
        const double y = model.weight()[m], omega = model.omega_radps()[m];
        accel += y * (y * force - omega * omega * state.eta[m]);
      }
      for (int k = 0; k < kSubsteps; ++k) model.step(state, 1 / kFs_Hz / kSubsteps);
      // The model's largest deflection excludes further contacts, so the ball is removed after the first separation.
      separated = separated || (force > 0 && model.read(state).force_N == 0);
      if (separated) state.ball_m = -1;
    }
    force_N.push_back(force);
    accel_mps2.push_back(kSensorGain * accel + 0.7 + 0.05 * gauss(random));
  }
}

class DeflectCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::ScratchFolder>();
    std::mt19937 random(1);
    std::vector<std::vector<double>> force;
    std::vector<std::vector<std::vector<double>>> accel;
    for (const double at_m : kPlaces_m) {
      for (int repeat = 0; repeat < 2; ++repeat)
        add_impact(at_m, random, force.emplace_back(), accel.emplace_back(1).front());
    }
    acquire::Record record = acquire::record_in_memory(kFs_Hz, std::move(force), std::move(accel));
    for (std::size_t row = 0; row < record.rows.size(); ++row) record.rows[row].point = static_cast<int>(row / 2);
    acquire::write_hdf5(file("bat.h5"), record, true);
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::string file(const std::string& name) { return folder_->file(name); }
  inline static std::unique_ptr<test::ScratchFolder> folder_;
};

TEST_F(DeflectCommand, PrintsADocumentThatFitsItsSchema) {
  const auto outcome =
      run_percuss({"deflect", file("bat.h5"), "--positions", "0.155:0.13:0.545", "--beam-distance", "0.1", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("deflection")), testing::IsEmpty());
  ASSERT_EQ(document["hits"].size(), 8U);
  EXPECT_EQ(document["hits"][0]["method"], "drift-free");
  EXPECT_NEAR(document["points"][3]["position_m"].get<double>(), 0.545, 1e-9);
  EXPECT_NEAR(document["impact_speeds"][0]["speed_mps"].get<double>(), 0.1 / kRest_s, 0.1);
}

TEST_F(DeflectCommand, ComparesWithAModel) {
  const test::ScratchFolder out;
  const auto run = [&](std::vector<std::string> arguments, const std::string& name) {
    arguments.insert(arguments.end(), {"-o", name, "--quiet"});
    const auto outcome = run_percuss(arguments, {.folder = out.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
  };
  run({"deflect", file("bat.h5"), "--positions", "0.155:0.13:0.545"}, "test.json");
  run({"model", "impact", "--sweep", "at=0.155:0.13:0.545"}, "model.json");
  run({"compare", "test.json", "model.json"}, "both.json");
  const json document = test::parse_json(test::bytes_of(out.file("both.json")));
  EXPECT_THAT(test::schema_violations(document, test::schema_named("compare")), testing::IsEmpty());
  ASSERT_EQ(document["deflections"].size(), kPlaces_m.size());
  for (const json& pair : document["deflections"]) {
    const double ratio = pair["ratio"], std = pair["ratio_std"];
    EXPECT_LE(std::abs(ratio - 1 / kSensorGain), 3.5 * std) << pair;  // 3.5, since four ratios are tested
    EXPECT_LE(std, 0.01 * ratio) << pair;                             // the ratio is precise
  }
  const auto text = run_percuss({"compare", "test.json", "model.json"}, {.folder = out.path()});
  EXPECT_THAT(text.out, HasSubstr("largest deflection"));
  const auto quoted = run_percuss({"compare", "[tm]*[tl].json"}, {.folder = out.path()});  // not expanded by a shell
  EXPECT_THAT(quoted.out, HasSubstr("largest deflection"));
  const auto none = run_percuss({"compare", "x*.json"}, {.folder = out.path()});
  EXPECT_THAT(none.err, HasSubstr("no file matches the pattern (x*.json)"));
}

// One command compares the frequencies and deflections of the test with a model beam and with a document.
TEST_F(DeflectCommand, ComparesItsModesAndDeflectionsWithABeam) {
  const test::ScratchFolder out;
  ASSERT_EQ(run_percuss({"model", "beam", "-o", "beam.json", "--quiet"}, {.folder = out.path()}).code, 0);
  const auto outcome = run_percuss({"deflect", file("bat.h5"), "--positions", "0.155:0.13:0.545", "--beam", "speed=5",
                                    "--compare", "beam.json", "--band", "5:3000", "--json"},
                                   {.folder = out.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = test::parse_json(outcome.out);
  const json& compared = document["comparison"];
  EXPECT_THAT(test::schema_violations(document, test::schema_named("deflection")), testing::IsEmpty());
  EXPECT_THAT(test::schema_violations(compared, test::schema_named("compare")), testing::IsEmpty());
  EXPECT_FALSE(document["modes"].empty());
  ASSERT_EQ(compared["documents"].size(), 3U);
  const json& model = compared["others"][0];
  EXPECT_GE(model["pairs"].size(), 2U);
  // The frequencies themselves are not checked: the ball's force hardly excites the modes above the first two.
  const json beam = test::parse_json(test::bytes_of(out.file("beam.json")))["frequency_hz"];
  for (const json& pair : model["pairs"]) {
    const double test_Hz = pair["frequency_a_hz"], model_Hz = pair["frequency_b_hz"];
    EXPECT_EQ(document["modes"][pair["a"].get<std::size_t>()]["frequency_hz"].get<double>(), test_Hz);
    EXPECT_EQ(beam[pair["b"].get<std::size_t>()].get<double>(), model_Hz);
    EXPECT_NEAR(pair["difference_percent"].get<double>(), 100 * (model_Hz / test_Hz - 1), 1e-9);
  }
  ASSERT_EQ(model["deflections"].size(), kPlaces_m.size());
  for (const json& pair : model["deflections"])
    EXPECT_NEAR(pair["ratio"].get<double>(), 1 / kSensorGain, 0.02) << pair;  // both without second contacts
  EXPECT_THAT(run_percuss({"deflect", file("bat.h5"), "--beam", "colour=3"}).err, HasSubstr("not a known name"));
  const auto in_lab_units =
      run_percuss({"deflect", file("bat.h5"), "--positions", "0.155:0.13:0.545", "--beam",
                   "speed=11.184681460272mph,length=57cm,ball_mass=160g", "--band", "5:3000", "--json"});
  ASSERT_EQ(in_lab_units.code, 0) << in_lab_units.err;
  const json other = test::parse_json(in_lab_units.out)["comparison"]["deflections"];
  ASSERT_EQ(other.size(), model["deflections"].size());
  for (std::size_t i = 0; i < other.size(); ++i)
    EXPECT_NEAR(other[i]["ratio"].get<double>(), model["deflections"][i]["ratio"].get<double>(), 1e-9);
}

TEST_F(DeflectCommand, WorksWithoutAForce) {
  const test::ScratchFolder out;
  const acquire::Record record = acquire::open_record(file("bat.h5"));
  std::vector<double> accel(record.rows[0].samples);
  record.read_accel_mps2(6, 0, 0, accel);
  std::string text = "t_s,acc_m_s2\n";
  for (std::size_t i = 0; i < accel.size(); ++i)
    text += fmt::format("{},{}\n", static_cast<double>(i) / kFs_Hz, accel[i]);
  test::write_bytes(out.file("accel.csv"), text);
  const auto with = run_percuss({"deflect", file("bat.h5"), "--json"});
  const auto without = run_percuss({"deflect", out.file("accel.csv"), "--json"});
  ASSERT_EQ(without.code, 0) << without.err;
  const json expected = test::parse_json(with.out)["hits"][6], found = test::parse_json(without.out)["hits"][0];
  EXPECT_EQ(found["method"], "drift-free");
  EXPECT_NEAR(found["peak_m"].get<double>(), expected["peak_m"].get<double>(),
              3 * expected["peak_std_m"].get<double>());
  EXPECT_THAT(test::rejection_of({"deflect", out.file("accel.csv"), "--method", "modal"}, {".json"}, "accel.csv"),
              HasSubstr("no force"));
  EXPECT_EQ(run_percuss({"analyze", out.file("accel.csv")}).code, 0);  // from free decays
}

TEST_F(DeflectCommand, WritesEverySample) {
  const test::ScratchFolder out;
  const auto outcome = run_percuss(
      {"deflect", file("bat.h5"), "--accept-hit", "1", "-o", "d.csv", "-o", "d.h5", "-o", "d.HDF5", "-o", "d.svg"},
      {.folder = out.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(test::lines_of(test::bytes_of(out.file("d.csv"))).size(), 1 + 8 * kLength_s * kFs_Hz);
  EXPECT_EQ(test::bytes_of(out.file("d.HDF5")), test::bytes_of(out.file("d.h5")));
  EXPECT_THAT(test::bytes_of(out.file("d.svg")), HasSubstr("deflection, mm"));
}

// A curve over time for each struck point, and the largest deflection over position: of the test, or beside a model.
TEST_F(DeflectCommand, DrawsEveryStruckPoint) {
  const test::ScratchFolder out;
  const std::vector<std::string> words{"deflect", file("bat.h5"), "--positions", "0.155:0.13:0.545"};
  std::vector<std::string> alone = words, beside = words;
  alone.insert(alone.end(), {"-o", "a.svg", "-o", "a.csv"});
  beside.insert(beside.end(), {"--beam", "speed=5", "--band", "5:3000", "-o", "b.svg"});
  ASSERT_EQ(run_percuss(alone, {.folder = out.path()}).code, 0);
  ASSERT_EQ(run_percuss(beside, {.folder = out.path()}).code, 0);
  for (const char* name : {"a.svg", "b.svg"}) {
    const std::string svg = test::bytes_of(out.file(name));
    EXPECT_THAT(svg, HasSubstr("Deflection at the struck points"));
    for (const char* place : {"0.155 m", "0.285 m", "0.415 m", "0.545 m"}) EXPECT_THAT(svg, HasSubstr(place));
  }
  EXPECT_THAT(test::bytes_of(out.file("a.svg")), HasSubstr("Largest deflection of the struck points"));
  EXPECT_THAT(test::bytes_of(out.file("b.svg")), HasSubstr("model beam"));
  auto curves = test::csv_columns(out.file("a.csv"));
  for (std::size_t point = 0; point < kPlaces_m.size(); ++point) {
    const auto row =
        static_cast<std::size_t>(std::find(curves["point"].begin(), curves["point"].end(), static_cast<double>(point)) -
                                 curves["point"].begin());
    ASSERT_LT(row, curves["point"].size());
    EXPECT_NEAR(curves["position_m"][row], kPlaces_m[point], 1e-12);
  }
}

// Table and document agree: the mean has the sign of the hits, or none where they differ in direction.
TEST_F(DeflectCommand, StatesTheDirectionOfTheMean) {
  const auto point_of = [](const std::vector<std::string>& words) {
    std::vector<std::string> as_json = words;
    as_json.emplace_back("--json");
    const json document = test::parse_json(run_percuss(as_json).out);
    EXPECT_THAT(test::schema_violations(document, test::schema_named("deflection")), testing::IsEmpty());
    return document["points"][0];
  };
  const json forward = point_of({"deflect", file("bat.h5")});
  const std::vector<std::string> reversed{"deflect", file("bat.h5"), "--accel-scale=-1"};
  const json backward = point_of(reversed);
  EXPECT_EQ(backward["direction"].get<int>(), -forward["direction"].get<int>());
  EXPECT_NEAR(backward["peak_m"].get<double>(), forward["peak_m"].get<double>(), 1e-9);
  const json hits = test::parse_json(run_percuss({"deflect", file("bat.h5"), "--json"}).out)["hits"];
  EXPECT_EQ(forward["direction"], hits[0]["direction"]);

  const test::ScratchFolder out;
  const acquire::Record mixed = test::with_changed_accel(acquire::open_record(file("bat.h5")),
                                                         [](std::size_t row, std::size_t, std::vector<double>& x) {
                                                           if (row != 1) return;
                                                           for (double& value : x) value = -value;
                                                         });
  acquire::write_hdf5(out.file("mixed.h5"), mixed, true);
  const json none = point_of({"deflect", out.file("mixed.h5")});
  EXPECT_TRUE(none["peak_m"].is_null() && none["peak_std_m"].is_null() && none["direction"].is_null());
  EXPECT_EQ(none["directions_differ"], true);
  EXPECT_GT(none["forward_m"].get<double>(), 0);
  EXPECT_THAT(run_percuss({"deflect", out.file("mixed.h5")}).out, HasSubstr("none: the hits differ in direction"));
}

TEST_F(DeflectCommand, NamesTheInvalidOption) {
  for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{{"--highpass-corner", "-1"},
                                                                                      {"--highpass-corner", "nan"},
                                                                                      {"--method", "magic"},
                                                                                      {"--effective-mass", "0"},
                                                                                      {"--beam-distance", "-2"},
                                                                                      {"--positions", "3:2:1"}}) {
    const auto outcome = run_percuss({"deflect", file("bat.h5"), option, value});
    EXPECT_EQ(outcome.code, 2) << option;
    EXPECT_THAT(outcome.err, HasSubstr(option));
  }
  EXPECT_THAT(test::rejection_of({"deflect", file("bat.h5"), "--positions", "0:0.1:0.2"}, {".json"}, "bat.h5"),
              HasSubstr("3 positions for 4 points"));
}

}  // namespace percuss::deflect_command_test
