#include "acquire/channels/role_guess.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "acquire/channels/csv_columns.hpp"
#include "core/error.hpp"

namespace percuss::acquire::role_guess_test {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kRounding = 1e-12;

std::vector<double> pulse(std::size_t samples, std::size_t width, double height) {
  std::vector<double> x(samples, 0.5);  // with an offset, which the median removes
  for (std::size_t i = 0; i < width; ++i) x[samples / 4 + i] += height;
  return x;
}

std::vector<double> sine(std::size_t samples) {
  std::vector<double> x;
  for (std::size_t i = 0; i < samples; ++i)
    x.push_back(std::sin(2 * std::numbers::pi * 10 * static_cast<double>(i) / static_cast<double>(samples)));
  return x;
}

// (Σ x²)²/(N Σ x⁴): m²/(N m) for m equal samples of N, the others at rest; (1/2)²/(3/8) for a sine.
TEST(ActiveShare, HasItsClosedForms) {
  EXPECT_NEAR(active_share(pulse(1000, 20, 300)), 0.02, kRounding);
  EXPECT_NEAR(active_share(pulse(1000, 20, -300)), 0.02, kRounding);
  EXPECT_NEAR(active_share(sine(1000)), 2.0 / 3, kRounding);
  EXPECT_EQ(active_share(std::vector<double>(10, 7.0)), 1);
  EXPECT_EQ(active_share({}), 1);
}

TEST(HammerDissimilarity, IsSmallForPulsesOfOneSign) {
  EXPECT_NEAR(hammer_dissimilarity(pulse(1000, 20, 300)), 0.05 * 0.02, kRounding);
  EXPECT_NEAR(hammer_dissimilarity(pulse(1000, 20, -300)), 0.05 * 0.02, kRounding) << "either sign";
  EXPECT_NEAR(hammer_dissimilarity(sine(1000)), 2.0 / 3, kRounding);
}

TEST(RisesEvenly, IsTrueForTimesOnly) {
  std::vector<double> time(100);
  for (std::size_t i = 0; i < time.size(); ++i) time[i] = std::round(1e4 * double(i) / 2560) / 1e4;  // to 0.1 ms
  EXPECT_TRUE(rises_evenly(time));
  time[50] += 1.0 / 2560;
  EXPECT_FALSE(rises_evenly(time)) << "a sample is lost";
  EXPECT_FALSE(rises_evenly(sine(100)));
  EXPECT_FALSE(rises_evenly(std::vector<double>(100, 1.0)));
}

TEST(UnreadHammer, IsNamedByItsNameOrItsPulses) {
  const std::vector<CsvColumn> columns{{.index = 0, .name = "t", .base = "t"},
                                       {.index = 1, .name = "ch1", .base = "ch1"},
                                       {.index = 2, .name = "a (g)", .base = "a", .unit = "g"},
                                       {.index = 3, .name = "hammer (g)", .base = "hammer", .unit = "g"}};
  CsvColumns known{.accel = {columns[2]}};
  known.time = columns[0];
  const auto note = [&](std::size_t count, const std::vector<double>& samples) {
    const auto found = unread_hammer_note({columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(count)},
                                          known, [&](std::size_t, std::size_t) { return samples; });
    return found ? found->text : "";
  };
  EXPECT_THAT(note(3, pulse(4000, 20, 300)), testing::StartsWith("ch1 looks like the hammer's force"));
  EXPECT_EQ(note(3, sine(4000)), "");
  EXPECT_THAT(note(4, sine(4000)), testing::StartsWith("hammer (g) looks like"));
  known.has_force = true;
  EXPECT_EQ(note(4, pulse(4000, 20, 300)), "");
}

TEST(GuessRoles, TakesThePulseAsTheForce) {
  std::vector<double> time(1000);
  for (std::size_t i = 0; i < time.size(); ++i) time[i] = double(i) / 1000;
  const std::vector<std::vector<double>> columns{time, sine(1000), pulse(1000, 10, 1)};
  std::vector<CsvColumn> signals;
  for (std::size_t i = 0; i < columns.size(); ++i)
    signals.push_back({.index = i, .name = "column " + std::to_string(i + 1), .base = ""});
  const auto read = [&](std::size_t index, std::size_t) { return columns[index]; };
  const RoleGuess guess = guess_roles(signals, {}, {}, read);
  EXPECT_EQ(guess.force, "3") << "a name with a blank is no word of a shell";
  EXPECT_THAT(guess.accel, ElementsAre("2"));
  EXPECT_TRUE(guess.rate_known);
  signals[2].name = "CH3";
  EXPECT_EQ(guess_roles(signals, {}, {}, read).force, "CH3");
  signals[1].name = "ch3";
  EXPECT_EQ(guess_roles(signals, {}, {}, read).force, "3") << "the name is not the only one";
}

// Oscilloscopes write settings in the first columns, and times in a later one.
TEST(GuessRoles, TakesEvenlyRisingNumbersAsTimesInAnyColumn) {
  std::vector<double> time(1000);
  for (std::size_t i = 0; i < time.size(); ++i) time[i] = -0.002 + static_cast<double>(i) * 4e-5;
  const std::vector<std::vector<double>> columns{time, sine(1000)};
  const auto read = [&](std::size_t index, std::size_t) { return columns[index - 3]; };
  const std::vector<CsvColumn> signals{{.index = 3, .name = "column 4", .base = ""},
                                       {.index = 4, .name = "column 5", .base = ""}};
  const RoleGuess guess = guess_roles(signals, {}, {}, read);
  EXPECT_EQ(guess.force, "");
  EXPECT_THAT(guess.accel, ElementsAre("5"));
  EXPECT_FALSE(guess.rate_known);
  EXPECT_NEAR(guess.assumed_rate_Hz, 25000, 1e-6);  // rounding of the times
}

// The hits of a test side by side, each with its force and its accelerometers.
TEST(GuessRoles, TakesTheFirstOfSeveralForcesWithItsResponses) {
  const auto read = [&](std::size_t index, std::size_t) { return index % 3 == 0 ? pulse(1000, 10, 1) : sine(1000); };
  std::vector<CsvColumn> signals;
  for (std::size_t i = 0; i < 6; ++i) {
    const std::string name = "c" + std::to_string(i);
    signals.push_back({.index = i, .name = name, .base = name, .unit = i % 3 == 0 ? "N" : "g"});
  }
  const RoleGuess guess = guess_roles(signals, {}, {}, read);
  EXPECT_EQ(guess.force, "c0");
  EXPECT_THAT(guess.accel, ElementsAre("c1", "c2"));
}

TEST(GuessRoles, TakesNeitherOfTwoAlikeSignalsAsTheForce) {
  const auto read = [&](std::size_t, std::size_t) { return sine(1000); };
  const std::vector<CsvColumn> signals{{.index = 0, .name = "left", .base = "left"},
                                       {.index = 1, .name = "right", .base = "right"}};
  EXPECT_EQ(guess_roles(signals, {}, {}, read).force, "");
  EXPECT_THAT(guess_roles(signals, {}, {}, read).accel, ElementsAre("left", "right"));
}

TEST(GuessRoles, TakesNoAccelerationAsTheForce) {
  const std::vector<std::vector<double>> columns{pulse(1000, 10, 1), sine(1000)};
  const auto read = [&](std::size_t index, std::size_t) { return columns[index]; };
  std::vector<CsvColumn> signals{{.index = 0, .name = "a", .base = "a", .unit = "cm/s2"},
                                 {.index = 1, .name = "b", .base = "b", .unit = "V"}};
  EXPECT_EQ(guess_roles(signals, {}, {}, read).force, "b");
  signals[1].unit = "g";
  EXPECT_EQ(guess_roles(signals, {}, {}, read).force, "");
  EXPECT_THAT(guess_roles(signals, {}, {}, read).accel, ElementsAre("a", "b"));
}

TEST(GuessRoles, KeepsWhatIsKnown) {
  const std::vector<std::vector<double>> columns{pulse(1000, 10, 1), sine(1000), pulse(1000, 20, 1), sine(1000)};
  const auto read = [&](std::size_t index, std::size_t) { return columns[index]; };
  std::vector<CsvColumn> signals;
  for (const char* name : {"a", "b", "c", "d"})
    signals.push_back({.index = signals.size(), .name = name, .base = name});
  CsvColumns known{.force = signals[1], .has_force = true, .accel = {}, .time = {}, .hit = {}, .point = {}, .run = {}};
  EXPECT_EQ(guess_roles(signals, known, {}, read).force, "b");
  EXPECT_THAT(guess_roles(signals, known, {}, read).accel, ElementsAre("a", "c", "d"));
  known = {};
  known.point = signals[0];
  EXPECT_EQ(guess_roles(signals, known, {}, read).force, "c");
  EXPECT_THAT(guess_roles(signals, known, {}, read).accel, ElementsAre("b", "d"));
  const RoleGuess typed = guess_roles(signals, {}, {.accel_channels = {"A", "4"}}, read);
  EXPECT_EQ(typed.force, "c");
  EXPECT_THAT(typed.accel, ElementsAre("A", "4"));
}

TEST(GuessRoles, FollowsTheRolesOfASetUp) {
  const std::vector<std::vector<double>> columns{pulse(1000, 10, 1), pulse(1000, 20, 1), pulse(1000, 30, 1)};
  const auto read = [&](std::size_t index, std::size_t) { return columns[index]; };
  std::vector<CsvColumn> signals;
  for (const char* name : {"a", "b", "c"}) signals.push_back({.index = signals.size(), .name = name, .base = name});
  const ReadOptions options{.setup = {{.name = "a", .role = "ignore"}, {.name = "b", .role = "acceleration"}}};
  const RoleGuess guess = guess_roles(signals, {}, options, read);
  EXPECT_EQ(guess.force, "c");
  EXPECT_THAT(guess.accel, ElementsAre("b"));
}

TEST(GuessRoles, LeavesOutSignalsThatCannotBeRead) {
  const std::vector<CsvColumn> signals{{.index = 0, .name = "a", .base = "a"}, {.index = 1, .name = "b", .base = "b"}};
  const RoleGuess guess = guess_roles(signals, {}, {}, [](std::size_t index, std::size_t) -> std::vector<double> {
    if (index == 0) throw InputError("damaged", "x", "y");
    return sine(100);
  });
  EXPECT_EQ(guess.force, "");
  EXPECT_THAT(guess.accel, ElementsAre("b"));
  EXPECT_FALSE(guess.rate_known);
  EXPECT_THAT(guess_roles({}, {}, {}, {}).accel, IsEmpty());
}

}  // namespace percuss::acquire::role_guess_test
