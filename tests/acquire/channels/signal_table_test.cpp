#include "acquire/channels/signal_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquire/channels/csv_columns.hpp"

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
