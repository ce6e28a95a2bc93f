#include "acquire/channels/signal_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquire/channels/csv_columns.hpp"
#include "acquire/record/note_codes.hpp"

namespace percuss::acquire::signal_table_test {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(FindRoles, FollowsTheUnitOfArrays) {
  SignalTable table{.format = "MAT",
                    .signals = {{.name = "p", .unit = "Pa", .shape = "4x1"},
                                {.name = "y_g", .shape = "4x2"},
                                {.name = "x", .unit = "lbf", .shape = "4x1"}}};
  const SignalRoles roles = find_roles(table, {});
  EXPECT_EQ(roles.force, 2U);
  EXPECT_THAT(roles.accel, ElementsAre(1U));
}

// A file may state that a signal is a pressure without stating its unit.
TEST(RecordOfTable, AssumesTheSiUnitOfTheQuantity) {
  SignalTable table{.format = "UFF",
                    .fs_Hz = 1000,
                    .signals = {{.name = "tip"}, {.name = "mic", .measures = Quantity::pressure}},
                    .rows = {{.samples = 4}},
                    .read = [](std::size_t, std::size_t, std::size_t, std::span<double>) {}};
  const Record record = record_of_table(table, {.has_force = false, .accel = {0, 1}}, {.force_optional = true});
  EXPECT_EQ(record.accel.at(0).unit, "m/s^2");
  EXPECT_EQ(record.accel.at(1).unit, "Pa");
  Message tip("the unit of tip is not stated; taken as m/s^2", {"unit"});
  Message microphone("the unit of mic is not stated; taken as Pa", {"unit"});
  tip.code = microphone.code = kResponseUnitAssumed;
  EXPECT_THAT(record.notes, testing::IsSupersetOf({tip, microphone}));
}

TEST(RecordOfTable, TurnsTheResponsesToABlowAlongANegativeDirection) {
  SignalTable table{.format = "MAT",
                    .fs_Hz = 1000,
                    .signals = {{.name = "f", .unit = "N"}, {.name = "a", .unit = "g"}},
                    .rows = {{.samples = 4}},
                    .read = [](std::size_t, std::size_t, std::size_t, std::span<double>) {}};
  const ReadOptions options{.setup = {{.name = "f", .sign = -1, .axis = Direction{0, 0, 1}}}};
  const Record record = record_of_table(table, {.force = 0, .has_force = true, .accel = {1}}, options);
  EXPECT_EQ(record.force.to_SI, 1);
  EXPECT_EQ(record.accel.at(0).to_SI, -kStandardGravity_mps2);
}

TEST(FindRoles, ListsTheShapesOfArraysThatAreAmbiguous) {
  SignalTable table{
      .format = "MAT",
      .signals = {{.name = "x", .unit = "N", .shape = "4x1"}, {.name = "y", .unit = "kN", .shape = "8x1"}}};
  try {
    find_roles(table, {});
    FAIL();
  } catch (const AmbiguousColumns& error) {
    EXPECT_THAT(error.what(), HasSubstr("2 columns could be the force: x [4x1], y [8x1]"));
    EXPECT_EQ(error.format, "MAT");
    EXPECT_EQ(error.columns.at(1).unit, "8x1");
  }
}

}  // namespace percuss::acquire::signal_table_test
