#include "acquire/formats/uff/uff_roles.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquire/channels/csv_columns.hpp"
#include "acquire/formats/uff/read_uff.hpp"
#include "support/files/csv_text.hpp"
#include "support/files/uff_text.hpp"
#include "support/record_samples.hpp"

// Which functions are forces, where neither unit nor type of data state it.
namespace percuss::acquire::uff_roles_test {

using test::accel_mps2;
using test::csv_bytes;
using test::force_N;
using test::UffText;
using testing::ElementsAre;

// A function of the numbers x and x + 1 whose axes state no quantity.
std::string unstated(const std::string& name, double x) {
  const UffText set{.response = name, .values = 2, .ordinate = 0};
  return set.text(fmt::format("{:13.5E}{:13.5E}\n", x, x + 1));
}

// Two hits: a response, then its force.
std::string two_hits(const std::string& force, const std::string& response) {
  return unstated(response, 3) + unstated(force, 1) + unstated(response, 7) + unstated(force, 5);
}

void expect_two_hits(const std::string& text, const ReadOptions& options) {
  const Record record = open_uff(csv_bytes(text), options);
  ASSERT_EQ(record.rows.size(), 2U);
  EXPECT_THAT(force_N(record, 0), ElementsAre(1, 2));
  EXPECT_THAT(force_N(record, 1), ElementsAre(5, 6));
  EXPECT_THAT(accel_mps2(record, 0, 0), ElementsAre(3, 4));
  EXPECT_THAT(accel_mps2(record, 0, 1), ElementsAre(7, 8));
}

TEST(UffRoles, FindAForceByItsNameInAnyLetterCase) {
  for (const char* name : {"force", "Force", "FORCE", "Hammer"}) {
    SCOPED_TRACE(name);
    expect_two_hits(two_hits(name, "acc"), {});
    expect_two_hits(two_hits(name, "ch2"), {.accel_channels = {"CH2"}});
  }
}

// The first ID line names a signal without a name of its own.
TEST(UffRoles, TakeTheIdLineAsTheNameOfASignal) {
  const auto function = [](const std::string& line, int node, double x) {
    const UffText set{.response_node = node, .values = 2, .ordinate = 0};
    std::string text = set.text(fmt::format("{:13.5E}{:13.5E}\n", x, x + 1));
    return text.replace(text.find("NONE"), 4, line);
  };
  const std::string hit = function("Impact hammer", 1, 1) + function("Left end", 2, 3);
  const Record record = open_uff(csv_bytes(hit + hit), {.accel_channels = {"left end"}});
  ASSERT_EQ(record.rows.size(), 2U);
  EXPECT_EQ(record.force.name, "Impact hammer");
  EXPECT_EQ(record.accel[0].name, "Left end");
  // Lines that number the hits name no signals.
  const std::string numbered = function("hit 1", 1, 1) + function("hit 1", 2, 3);
  EXPECT_EQ(open_uff(csv_bytes(numbered), {.force_channel = "1", .accel_channels = {"2"}}).accel[0].name, "2+Z");
}

TEST(UffRoles, FindAForceByTheLabelOfItsAxis) {
  std::string text = unstated("a", 3) + unstated("b", 1) + unstated("c", 7) + unstated("b", 5);
  // The label of a function's ordinate stands in columns 27 to 46 of record 9.
  for (const auto& [name, label] : {std::pair{"b", "FORCE"}, std::pair{"a", "Acceleration"}, std::pair{"c", "acc."}}) {
    const std::string response = fmt::format(" {:<10}{:10}", name, 1);
    for (auto at = text.find(response); at != std::string::npos; at = text.find(response, at + 1))
      text.replace(text.find("         0    0    0    0 NONE", at) + 26, 20, fmt::format("{:<20}", label));
  }
  const Record record = open_uff(csv_bytes(text));
  ASSERT_EQ(record.rows.size(), 2U);
  EXPECT_THAT(force_N(record, 1), ElementsAre(5, 6));
}

TEST(UffRoles, FollowTheOptionInAnyLetterCase) {
  expect_two_hits(two_hits("Ch1", "ch2"), {.force_channel = "CH1", .accel_channels = {"Ch2"}});
  expect_two_hits(two_hits("Ch1", "ch2"),
                  {.setup = {{.name = "ch1", .role = "force"}, {.name = "CH2", .role = "acceleration"}}});
}

TEST(UffRoles, FollowNumbersInTheOrderOfTheFile) {
  expect_two_hits(two_hits("a", "b"), {.force_channel = "2", .accel_channels = {"1"}});
  expect_two_hits(two_hits("a", "b"),
                  {.setup = {{.name = "2", .role = "force"}, {.name = "1", .role = "acceleration"}}});
  // Two functions of one name form a single row. Both have this name, so the options still select them by number.
  const Record one =
      open_uff(csv_bytes(unstated("a", 3) + unstated("a", 1)), {.force_channel = "2", .accel_channels = {"1"}});
  ASSERT_EQ(one.rows.size(), 1U);
  EXPECT_THAT(force_N(one), ElementsAre(1, 2));
}

TEST(UffRoles, LeaveTwoForcesToTheUser) {
  const std::string text = unstated("Force 1", 1) + unstated("Force 2", 3) + unstated("acc", 5);
  EXPECT_THROW(open_uff(csv_bytes(text)), AmbiguousColumns);
}

}  // namespace percuss::acquire::uff_roles_test
