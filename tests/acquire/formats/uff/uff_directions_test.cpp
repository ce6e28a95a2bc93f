#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquire/channels/stored_frfs.hpp"
#include "acquire/formats/uff/read_frf_uff.hpp"
#include "acquire/formats/uff/read_uff.hpp"
#include "acquire/formats/uff/write_uff.hpp"
#include "acquire/open_measurement.hpp"
#include "core/units.hpp"
#include "support/files/csv_text.hpp"
#include "support/files/uff_record.hpp"
#include "support/files/uff_text.hpp"
#include "support/input_error.hpp"
#include "support/messages.hpp"
#include "support/record_samples.hpp"
#include "support/scratch_folder.hpp"

// What the directions of data set 58 mean for signs, points, roving sensors and shapes.
namespace percuss::acquire::uff_directions_test {

using test::accel_mps2;
using test::csv_bytes;
using test::force_N;
using test::input_error_of;
using test::opened_uff;
using test::UffText;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr Direction kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

struct Dof {
  int node, direction;
};

// An FRF with the values x and 2x at 10 and 12 Hz.
std::string frf(Dof response, Dof reference, double x, const std::string& name = "NONE") {
  const UffText set{.type = 4,
                    .response = name,
                    .response_node = response.node,
                    .response_direction = response.direction,
                    .reference_node = reference.node,
                    .reference_direction = reference.direction,
                    .ordinate_type = 5,
                    .values = 2,
                    .x0 = "  1.00000E+01",
                    .dx = "  2.00000E+00",
                    .abscissa = 18,
                    .denominator = 13,
                    .ordinate_unit = "m/s^2",
                    .denominator_unit = "N"};
  return set.text(fmt::format("{:13.5E}{:13.5E}{:13.5E}{:13.5E}\n", x, 0.0, 2 * x, 0.0));
}

FrfRecord read(const std::string& text) {
  const FileBytes bytes = csv_bytes(text);
  auto stored = read_frf_uff(bytes, read_uff_contents(bytes), false);
  EXPECT_TRUE(stored.has_value());
  return to_accelerances(std::move(stored).value(), {});
}

// The first value of each FRF, point by point.
std::vector<double> values(const FrfRecord& record) {
  std::vector<double> out;
  for (const PointFrf& one : record.frfs) out.push_back(one.frf.value.at(0).real());
  return out;
}

std::vector<int> points(const FrfRecord& record) {
  std::vector<int> out;
  for (const PointFrf& one : record.frfs) out.push_back(one.point);
  return out;
}

// A hit: a force of 1 and 2 N at `struck`, and responses of 3 and 4 m/s².
std::string hit(Dof struck, const std::vector<Dof>& responses) {
  const auto function = [&](const char* name, Dof at, int quantity, const char* unit, double x) {
    const UffText set{.response = name,
                      .response_node = at.node,
                      .response_direction = at.direction,
                      .reference_node = struck.node,
                      .reference_direction = struck.direction,
                      .values = 2,
                      .ordinate = quantity,
                      .ordinate_unit = unit};
    return set.text(fmt::format("{:13.5E}{:13.5E}\n", x, x + 1));
  };
  std::string out = function("hammer", struck, 13, "N", 1);
  for (const Dof& at : responses) out += function("NONE", at, 12, "m/s^2", 3);
  return out;
}

TEST(UffDirections, ChangeTheSignOfFrfsInNegativeDirections) {
  const FrfRecord record = read(frf({1, 3}, {4, 3}, 1) + frf({1, 3}, {5, -3}, 1) + frf({1, 3}, {6, -1}, 1));
  EXPECT_THAT(values(record), ElementsAre(1, -1, -1));
  EXPECT_THAT(test::texts(record.notes), ElementsAre(HasSubstr("the sign of 2 of 3 FRFs is changed")));
  EXPECT_TRUE(record.notes[0].information);
  EXPECT_THAT(values(read(frf({1, -3}, {4, 3}, 1) + frf({1, -3}, {5, -3}, 1))), ElementsAre(-1, 1));
  EXPECT_THAT(values(read(frf({1, -5}, {4, 0}, 1))), ElementsAre(-1)) << "a rotation";
}

// One sensor that was turned between the points is one channel.
TEST(UffDirections, MakeOneChannelOfBothSignsOfAResponse) {
  const FrfRecord record = read(frf({1, 3}, {4, 3}, 1) + frf({1, -3}, {5, 3}, 1));
  EXPECT_EQ(record.accel.size(), 1U);
  EXPECT_THAT(values(record), ElementsAre(1, -1));
  EXPECT_EQ(read(frf({1, 3}, {4, 3}, 1) + frf({1, -3}, {4, 3}, 1)).accel.size(), 2U) << "two sensors of one point";
}

TEST(UffDirections, AreThoseOfPointsAndSensors) {
  const FrfRecord record = read(frf({1, -2}, {4, -3}, 1) + frf({1, -2}, {5, 1}, 1) + frf({1, -2}, {6, 0}, 1));
  EXPECT_THAT(record.motions, ElementsAre(PointMotion{.point = 4, .place = 4, .along = kZ},
                                          PointMotion{.point = 5, .place = 5, .along = kX}));
  EXPECT_EQ(record.accel[0].axis, kY);
  EXPECT_FALSE(record.sensor_roves);
}

// Set 18 defines a cylindrical system 2 around z. Of the nodes of set 15, node 4 lies at 90° and node 5 on the axis;
// node 6 has the undefined system 7.
TEST(UffDirections, AreInTheDisplacementSystemOfTheNode) {
  const std::string systems =
      "    -1\n    18\n         2         1         0\ncylinder\n"
      "  0.00000E+00  0.00000E+00  0.00000E+00  1.00000E+00  0.00000E+00  0.00000E+00\n"
      "  1.00000E+00  0.00000E+00  1.00000E+00\n    -1\n";
  const std::string nodes =
      "    -1\n    15\n"
      "         4         0         2         0  0.00000E+00  2.00000E+00  0.50000E+00\n"
      "         5         0         2         0  0.00000E+00  0.00000E+00  0.50000E+00\n"
      "         6         0         7         0  1.00000E+00  0.00000E+00  0.00000E+00\n    -1\n";
  const FrfRecord record =
      read(systems + nodes + frf({1, 3}, {4, -2}, 1) + frf({1, 3}, {5, 1}, 1) + frf({1, 3}, {6, 1}, 1));
  ASSERT_EQ(record.motions.size(), 1U) << "no direction on the axis, or in an undefined system";
  EXPECT_EQ(record.motions[0].point, 4);
  const Direction expected{-1, 0, 0};  // the direction of increasing angle at 90°
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(record.motions[0].along->at(i), expected.at(i), 1e-15);
  EXPECT_THAT(values(record), ElementsAre(-1, 1, 1));
}

TEST(UffDirections, MakeSeveralPointsOfANode) {
  const FrfRecord record =
      read(frf({1, 3}, {4, 3}, 1) + frf({1, 3}, {4, -2}, 2) + frf({1, 3}, {12, 2}, 3) + frf({1, 3}, {1, 3}, 4));
  EXPECT_THAT(points(record), ElementsAre(4, 12, 101, 104)) << "y is the first direction";
  EXPECT_THAT(values(record), ElementsAre(-2, 3, 4, 1));
  EXPECT_THAT(record.driving, ElementsAre(DrivingPlace{101, 0}));
  EXPECT_EQ(place_of_point(record.motions, 104), 4);
  EXPECT_EQ(find_motion(record.motions, 104, 0)->along, kZ);
  EXPECT_EQ(find_motion(record.motions, 4, 0)->along, kY);
  EXPECT_THAT(test::texts(record.notes),
              testing::Contains(HasSubstr("point n is node n in y, 100 + n is node n in z")));
  EXPECT_THAT(input_error_of([&] {
                read(frf({1, 3}, {4, 3}, 1) + frf({1, 3}, {4, -3}, 1));
              }),
              HasSubstr("two FRFs of channel 1 at point 4"));
}

TEST(UffDirections, TellThatSensorsRoved) {
  const FrfRecord record = read(frf({4, 1}, {1, -3}, 1, "a") + frf({4, 3}, {1, -3}, 2, "b") +
                                frf({1, -1}, {1, -3}, 3, "c") + frf({1, 3}, {1, -3}, 4, "d"));
  EXPECT_TRUE(record.sensor_roves);
  ASSERT_EQ(record.accel.size(), 2U) << "one per direction, whatever the names";
  EXPECT_THAT(points(record), ElementsAre(1, 1, 4, 4));
  EXPECT_THAT(values(record), ElementsAre(3, -4, -1, -2));
  EXPECT_THAT(record.driving, ElementsAre(DrivingPlace{1, 1}));
  EXPECT_EQ(find_motion(record.motions, 4, 0)->along, kX);
  EXPECT_EQ(find_motion(record.motions, 4, 1)->along, kZ);
  FileBytes bytes =
      csv_bytes(frf({4, 1}, {1, 3}, 1) + frf({4, 3}, {1, 3}, 2) + frf({2, 1}, {1, 3}, 3) + frf({2, 3}, {1, 3}, 4));
  FrfReadOptions second;
  second.read.accel_channels = {"2"};
  const FrfRecord chosen = to_accelerances(*read_frf_uff(bytes, read_uff_contents(bytes), false), second);
  ASSERT_EQ(chosen.motions.size(), 2U);
  EXPECT_EQ(find_motion(chosen.motions, 4, 0)->along, kZ);
}

TEST(UffDirections, ChangeTheSignOfResponsesOverTime) {
  const Record record = opened_uff(hit({4, 3}, {{1, 3}, {1, -1}}) + hit({5, -2}, {{1, 3}, {1, -1}}));
  EXPECT_THAT(force_N(record, 1), ElementsAre(1, 2)) << "a pulse stays positive";
  EXPECT_THAT(accel_mps2(record, 0, 0), ElementsAre(3, 4));
  EXPECT_THAT(accel_mps2(record, 1, 0), ElementsAre(-3, -4));
  EXPECT_THAT(accel_mps2(record, 0, 1), ElementsAre(-3, -4));
  EXPECT_THAT(accel_mps2(record, 1, 1), ElementsAre(3, 4));
  EXPECT_THAT(test::texts(record.notes), ElementsAre(HasSubstr("the sign of 2 of 4 responses is changed")));
  EXPECT_THAT(record.motions, ElementsAre(PointMotion{.point = 4, .place = 4, .along = kZ},
                                          PointMotion{.point = 5, .place = 5, .along = kY}));
  EXPECT_EQ(record.accel[1].axis, kX);
}

// Without a force, only the sensor's own direction counts.
TEST(UffDirections, ChangeTheSignOfResponsesWithoutAForce) {
  const UffText set{.response_node = 1,
                    .response_direction = -3,
                    .reference_node = 1,
                    .reference_direction = -3,
                    .values = 2,
                    .ordinate_unit = "m/s^2"};
  const FileBytes bytes = csv_bytes(set.text("  1.00000E+00  2.00000E+00\n"));
  EXPECT_THAT(accel_mps2(open_uff(bytes, {.force_optional = true})), ElementsAre(-1, -2));
}

TEST(UffDirections, MakeSeveralPointsOfANodeOverTime) {
  const Record record = opened_uff(hit({4, 3}, {{1, 3}}) + hit({4, -3}, {{1, 3}}) + hit({4, 1}, {{1, 3}}));
  EXPECT_EQ(record.rows[0].point, 14);
  EXPECT_EQ(record.rows[1].point, 14) << "one degree of freedom, struck from both sides";
  EXPECT_EQ(record.rows[2].point, 4);
  EXPECT_EQ(place_of_point(record.motions, 14), 4);
  const Record unnumbered = opened_uff(hit({0, 3}, {{1, 3}}) + hit({0, 1}, {{1, 3}}));
  EXPECT_EQ(unnumbered.rows[0].point, 10);
  EXPECT_EQ(unnumbered.rows[1].point, 0);
}

TEST(UffDirections, TellThatSensorsRovedOverTime) {
  const Record record =
      opened_uff(hit({1, 3}, {{4, 1}, {4, 3}}) + hit({1, 3}, {{4, 1}, {4, 3}}) + hit({1, 3}, {{7, 1}, {7, -3}}));
  EXPECT_TRUE(record.sensor_roves);
  EXPECT_EQ(record.rows[1].point, 4);
  EXPECT_EQ(record.rows[2].point, 7);
  EXPECT_EQ(find_motion(record.motions, 7, 1)->along, kZ);
  EXPECT_THAT(accel_mps2(record, 1, 2), ElementsAre(-3, -4));
  EXPECT_THAT(input_error_of([&] {
                opened_uff(hit({1, 3}, {{4, 1}, {5, 1}}) + hit({1, 3}, {{6, 1}, {7, 1}}));
              }),
              HasSubstr("response 1 is at node 4 in hit 1 and at node 6 in hit 2"));
  EXPECT_FALSE(opened_uff(hit({1, 3}, {{4, 1}, {5, 1}}) + hit({1, 3}, {{4, 1}, {5, 1}})).sensor_roves);
}

// In a file that percuss wrote, a direction only states the angle of a sensor. It does not change the sign of samples.
TEST(UffDirections, OfPercussChangeNoSign) {
  Record record = record_in_memory(1000, {{1, 2}}, {{{3, -4}}});
  record.accel[0].angle_rad = 180 * kDegree_rad;  // direction −2
  const test::ScratchFolder folder;
  write_uff(folder.file("r.uff"), record, false);
  const Record again = open_record(folder.file("r.uff"));
  EXPECT_THAT(accel_mps2(again), ElementsAre(3, -4));
  EXPECT_THAT(again.motions, IsEmpty());
  EXPECT_FALSE(again.accel[0].axis);
}

}  // namespace percuss::acquire::uff_directions_test
