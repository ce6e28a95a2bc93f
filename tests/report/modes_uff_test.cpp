#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "acquire/formats/uff/uff_file.hpp"
#include "support/files/csv_text.hpp"
#include "support/files/synthetic_files.hpp"
#include "support/files/uff_text.hpp"
#include "support/json.hpp"
#include "support/json_schema.hpp"
#include "support/modal_frfs.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"
#include "support/small_records.hpp"

namespace percuss::report::modes_uff_test {

using test::csv_bytes;
using test::run_percuss;

std::vector<std::string_view> lines_of_set(const acquire::UffSet& set) {
  std::vector<std::string_view> lines;
  for (std::string_view rest = set.text; !rest.empty();) lines.push_back(acquire::take_uff_line(rest));
  return lines;
}

std::vector<double> numbers_in(std::string_view line) {
  std::vector<double> out;
  for (acquire::UffFields fields(line); !fields.blank();) out.push_back(fields.number(13).value());
  return out;
}

// The small test has a bending mode at 200 Hz (1 % damping, residues in the ratio 0.9 to 0.3 at the two sensors) and a
// hoop mode at 700 Hz (0.5 %).
TEST(ModesUff, ContainsEachModeAs55AndAs2414) {
  const test::ScratchFolder folder;
  test::write_small_test(folder.file("bat.h5"));
  const auto outcome =
      run_percuss({"analyze", folder.file("bat.h5"), "--band", "60:1000", "-o", folder.file("modes.uff")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const FileBytes bytes = csv_bytes(test::bytes_of(folder.file("modes.uff")));
  const auto sets = acquire::split_uff(bytes);
  ASSERT_EQ(sets.size(), 6U);
  EXPECT_EQ(sets[0].number, 151);
  EXPECT_EQ(sets[1].number, 164);
  const auto set_55 = lines_of_set(sets[2]), set_2414 = lines_of_set(sets[3]);
  ASSERT_EQ(sets[2].number, 55);
  ASSERT_EQ(set_55.size(), 10U);
  EXPECT_EQ(set_55[5], "         1         3         2         8         5         3");
  EXPECT_EQ(set_55[6], "         2         6         1         1");
  // Relative: the noise of the record (4e-5 of the decay rate), the damped frequency compared with the undamped one
  // (ζ²/2 = 5e-5), and the six digits of a number (5e-6).
  constexpr double kFitted = 3e-4;
  constexpr double kFitted_Hz = 0.01;
  const double omega = 2 * std::numbers::pi * 200;
  const auto eigenvalue = numbers_in(set_55[7]);
  EXPECT_NEAR(eigenvalue[0] / (-0.01 * omega), 1, kFitted);
  EXPECT_NEAR(eigenvalue[1] / omega, 1, kFitted);
  EXPECT_EQ(set_55[8], "         1") << "point 0 is node 1";
  const auto shape = numbers_in(set_55[9]);
  ASSERT_EQ(shape.size(), 6U);
  EXPECT_EQ(shape[0], 0) << "nothing along the axis";
  EXPECT_NEAR(shape[2], 1, kFitted) << "the sensor at 0 degrees looks along y";
  EXPECT_NEAR(shape[4], 0.3 / 0.9, kFitted);
  ASSERT_EQ(sets[3].number, 2414);
  EXPECT_EQ(set_2414[2], "         1") << "data at nodes";
  EXPECT_EQ(set_2414[8], "         1         3         2         8         5         3");
  const auto record12 = numbers_in(set_2414[11]);
  EXPECT_NEAR(record12[1], 200, kFitted_Hz);
  EXPECT_NEAR(record12[4] / 0.01, 1, kFitted);
  EXPECT_EQ(set_2414.back(), set_55.back());
}

// A mode at 200 Hz of four nodes, the corners of a square: components along x, y and z, in 1/√kg.
constexpr std::array<std::array<double, 3>, 4> kMotion{
    {{0.1, -0.4, 0.9}, {-0.6, 0.3, -0.5}, {0.7, 0.2, -0.35}, {-0.15, -0.8, 0.55}}};
const std::string kSquare =
    "    -1\n    15\n"
    "         1         0         0         0  0.00000E+00  0.00000E+00  0.00000E+00\n"
    "         2         0         0         0  1.00000E+00  0.00000E+00  0.00000E+00\n"
    "         3         0         0         0  1.00000E+00  1.00000E+00  0.00000E+00\n"
    "         4         0         0         0  0.00000E+00  1.00000E+00  0.00000E+00\n    -1\n";

// Node, from 1, and direction ±1 … ±3.
struct Dof {
  int node, direction;
};

double component(const Dof& at) {
  return (at.direction < 0 ? -1 : 1) *
         kMotion.at(static_cast<std::size_t>(at.node - 1)).at(static_cast<std::size_t>(std::abs(at.direction) - 1));
}

std::string frf_between(const Dof& response, const Dof& reference, bool stated = true) {
  constexpr std::size_t kLines = 400;
  const test::UffText set{.type = 4,
                          .response_node = response.node,
                          .response_direction = response.direction,
                          .reference_node = reference.node,
                          .reference_direction = stated ? reference.direction : 0,
                          .ordinate_type = 5,
                          .values = kLines,
                          .dx = "  1.00000E+00",
                          .abscissa = 18,
                          .denominator = 13,
                          .ordinate_unit = "m/s^2",
                          .denominator_unit = "N"};
  const identify::Pole pole{.freq_Hz = 200, .damping_ratio = 0.01};
  std::string numbers;
  for (std::size_t k = 0; k < kLines; ++k) {
    const Complex h = component(response) * component(reference) *
                      test::mode_accelerance(pole, Complex(0, 2 * M_PI * static_cast<double>(k)));
    numbers += fmt::format("{:13.5E}{:13.5E}{}", h.real(), h.imag(), k % 3 == 2 ? "\n" : "");
  }
  return set.text(numbers + "\n");
}

// The motion of each node in the first mode of a written file.
std::map<int, std::array<double, 3>> motion_in(const std::string& path) {
  std::map<int, std::array<double, 3>> out;
  const FileBytes bytes = csv_bytes(test::bytes_of(path));
  for (const acquire::UffSet& set : acquire::split_uff(bytes)) {
    if (set.number != 55 || !out.empty()) continue;
    const auto lines = lines_of_set(set);
    for (std::size_t i = 8; i + 1 < lines.size(); i += 2) {
      const auto numbers = numbers_in(lines[i + 1]);
      out[std::stoi(std::string(lines[i]))] = {numbers.at(0), numbers.at(2), numbers.at(4)};
    }
  }
  return out;
}

// The motion of the nodes along the blows (node 1, +z), (2, −x), (3, +y) and (4, −z).
const std::map<int, std::array<double, 3>> kStruckMotion{
    {1, {0, 0, 0.9}}, {2, {-0.6, 0, 0}}, {3, {0, 0.2, 0}}, {4, {0, 0, 0.55}}};

class StatedDirections : public testing::Test {
 protected:
  static constexpr double kWithin = 1e-4;  // six digits of the FRFs in the file

  // Runs a survey of FRFs between these degrees of freedom. Returns its document; motion_ is the motion in its file of
  // mode shapes.
  nlohmann::json survey(const std::vector<std::pair<Dof, Dof>>& pairs) {
    std::string text = kSquare;
    for (const auto& [response, reference] : pairs) text += frf_between(response, reference);
    test::write_bytes(folder_.file("frf.uff"), text);
    const auto outcome = run_percuss(
        {"survey", folder_.file("frf.uff"), "--band", "150:250", "--json", "--force", "-o", folder_.file("modes.uff")});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    motion_ = motion_in(folder_.file("modes.uff"));
    const auto document = test::parse_json(outcome.out);
    EXPECT_THAT(test::schema_violations(document, test::schema_named("analysis")), testing::IsEmpty());
    return document;
  }
  void expect_the_motion_of_all_nodes() const {
    ASSERT_EQ(motion_.size(), 4U);
    for (const auto& [node, motion] : motion_) {
      const auto& expected = kMotion.at(static_cast<std::size_t>(node - 1));
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(motion.at(i), expected.at(i), kWithin) << node << " " << i;
    }
  }
  test::ScratchFolder folder_;
  std::map<int, std::array<double, 3>> motion_;
};

TEST_F(StatedDirections, MoveTheNodesOfARovingHammer) {
  const Dof sensor{1, 3};
  const auto document = survey({{sensor, {1, 3}}, {sensor, {2, -1}}, {sensor, {3, 2}}, {sensor, {4, -3}}});
  EXPECT_EQ(document["roving"], "hammer");
  EXPECT_EQ(document["motion"][1], nlohmann::json::parse(R"({"point": 2, "place": 2, "direction": [1.0, 0.0, 0.0]})"));
  EXPECT_NEAR(document["modes"][0]["shape"]["modal_mass_kg"].get<double>(), 1 / (0.9 * 0.9), kWithin);
  ASSERT_EQ(motion_.size(), 4U);
  for (const auto& [node, motion] : kStruckMotion) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(motion_[node].at(i), motion.at(i), kWithin) << node << " " << i;
  }
}

TEST_F(StatedDirections, MoveTheNodesOfHammersInThreeDirections) {
  std::vector<std::pair<Dof, Dof>> pairs;
  for (int node = 1; node <= 4; ++node) {
    for (const int direction : {1, -2, 3}) {
      pairs.push_back({{1, 3}, {node, direction}});
      pairs.push_back({{3, -1}, {node, direction}});
    }
  }
  const auto document = survey(pairs);
  EXPECT_EQ(document["modes"][0]["shape"]["values"].size(), 12U);
  EXPECT_NEAR(document["modes"][0]["shape"]["modal_mass_kg"].get<double>(), 1 / (0.9 * 0.9), kWithin);
  expect_the_motion_of_all_nodes();
}

TEST_F(StatedDirections, MoveTheNodesOfARovingTriaxialSensor) {
  std::vector<std::pair<Dof, Dof>> pairs;
  for (int node = 1; node <= 4; ++node) {
    for (const int direction : {1, 2, -3}) pairs.push_back({{node, direction}, {1, -3}});
  }
  const auto document = survey(pairs);
  EXPECT_EQ(document["roving"], "sensor");
  EXPECT_NEAR(document["modes"][0]["shape"]["modal_mass_kg"].get<double>(), 1 / (0.9 * 0.9), kWithin);
  expect_the_motion_of_all_nodes();
}

// Blows whose directions only the geometry states.
TEST_F(StatedDirections, AreThoseOfTheGeometry) {
  const Dof sensor{1, 3};
  std::string text;
  for (const Dof& blow : {Dof{1, 3}, Dof{2, -1}, Dof{3, 2}, Dof{4, -3}}) text += frf_between(sensor, blow, false);
  test::write_bytes(folder_.file("frf.uff"), text);
  const auto run = [&](const std::string& geometry) {
    test::write_bytes(folder_.file("points.csv"), geometry);
    return run_percuss({"survey", folder_.file("frf.uff"), "--band", "150:250", "--geometry",
                        folder_.file("points.csv"), "--json", "--force", "-o", folder_.file("modes.uff")});
  };
  for (const char* geometry : {"point,x_m,y_m,dx,dy,dz\n1,0,0,,,2\n2,1,0,-1,0,0\n3,1,1,0,0.5,0\n4,0,1,0,0,-1\n",
                               "point,x_m,y_m,direction\n1,0,0,\n2,1,0,-x\n3,1,1,+Y\n4,0,1,-z\n"}) {
    const auto outcome = run(geometry);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto document = test::parse_json(outcome.out);
    EXPECT_THAT(test::schema_violations(document, test::schema_named("analysis")), testing::IsEmpty());
    EXPECT_EQ(document["places"][1]["direction"], nlohmann::json::parse("[-1.0, 0.0, 0.0]"));
    auto motion = motion_in(folder_.file("modes.uff"));
    ASSERT_EQ(motion.size(), 4U);
    const double scale = 0.9 / motion[1][2];
    for (const auto& [node, moved] : kStruckMotion) {
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(scale * motion[node].at(i), moved.at(i), kWithin) << node << " " << i << " " << geometry;
    }
  }
}

// The reader has changed the sign of a blow along −x, so that the record's direction counts.
TEST_F(StatedDirections, OfTheRecordPrecedeThoseOfTheGeometry) {
  const Dof sensor{1, 3};
  std::string text;
  for (const Dof& blow : {Dof{1, 3}, Dof{2, -1}}) text += frf_between(sensor, blow);
  test::write_bytes(folder_.file("frf.uff"), text);
  const auto run = [&](const std::string& direction) {
    test::write_bytes(folder_.file("points.csv"), "point,x_m,y_m,direction\n1,0,0,\n2,1,0," + direction + "\n");
    return run_percuss({"survey", folder_.file("frf.uff"), "--band", "150:250", "--geometry",
                        folder_.file("points.csv"), "--force", "-o", folder_.file("modes.uff")});
  };
  ASSERT_EQ(run("-x").code, 0);
  auto motion = motion_in(folder_.file("modes.uff"));
  EXPECT_NEAR(motion[2][0] / motion[1][2], -0.6 / 0.9, kWithin);
  const auto refused = run("+y");
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err,
              testing::HasSubstr("the geometry states one direction of point 2, the record or its set-up another one"));
}

TEST_F(StatedDirections, OfTheGeometryAreOneForEachPlace) {
  std::string text;
  for (const int direction : {1, 3}) {
    for (int node = 1; node <= 4; ++node) text += frf_between({1, 3}, {node, direction});
  }
  test::write_bytes(folder_.file("frf.uff"), text);
  test::write_bytes(folder_.file("points.csv"), "point,x_m,y_m,dz\n1,0,0,1\n2,1,0,1\n3,1,1,1\n4,0,1,1\n");
  const auto refused =
      run_percuss({"survey", folder_.file("frf.uff"), "--band", "150:250", "--geometry", folder_.file("points.csv")});
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, testing::HasSubstr("of point 1, which was struck in several"));
}

// Sensors without an angle, whose directions the set-up states. A sandboxed process reads the HDF5 file and passes them
// on.
TEST_F(StatedDirections, AreThoseOfTheSetUp) {
  const test::SmallRecord one = test::small_record();
  std::vector<double> half;
  for (const double a : one.accel_mps2) half.push_back(a / 2);
  test::write_columns(folder_.file("two.csv"), "time_s,force_N,a_mps2,b_mps2",
                      {one.time_s, one.force_N, one.accel_mps2, half});
  ASSERT_EQ(run_percuss({"convert", folder_.file("two.csv"), folder_.file("two.h5")}).code, 0);
  test::write_bytes(folder_.file("setup.json"), R"([{"name": "accel 1", "direction": "-x"},
                                                   {"name": "accel 2", "direction": "+z"}])");
  const auto outcome = run_percuss({"analyze", folder_.file("two.h5"), "--setup", folder_.file("setup.json"), "--band",
                                    "60:1000", "-o", folder_.file("modes.uff")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  auto motion = motion_in(folder_.file("modes.uff"));
  ASSERT_EQ(motion.size(), 1U);
  const auto& [x, y, z] = motion[1];
  EXPECT_NEAR(std::abs(x), 1, kWithin);
  EXPECT_EQ(y, 0);
  EXPECT_NEAR(z / x, -0.5, kWithin);
}

}  // namespace percuss::report::modes_uff_test
