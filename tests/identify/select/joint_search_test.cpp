#include <gtest/gtest.h>

#include "identify/identify.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::joint_search_test {

FrfDataset set_of(const std::vector<Pole>& modes) {
  FrfDataset set = test::empty_set(8192, 8192, 40, 1500, 2);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    test::add_mode(set, 0, modes[m], 0.8);
    test::add_mode(set, 1, modes[m], m % 2 == 0 ? 0.5 : -0.3);
  }
  test::add_frf_noise(set, 1e-3, 3);
  return set;
}

// Half-power bandwidths of 68, 176 and 360 Hz: no peak has a window of its own.
TEST(SearchJointly, FindsModesWithADampingRatioOfTwentyPerCent) {
  const std::vector<Pole> truth{{170, 0.2}, {490, 0.18}, {900, 0.2}};
  test::expect_modes_near(identify_modes(set_of(truth)), truth);
}

TEST(KeepClearest, GivesAsManyModesAsAskedFor) {
  const std::vector<Pole> truth{{200, 0.01}, {500, 0.008}, {800, 0.01}, {1100, 0.006}};
  for (const std::size_t count : {1U, 2U, 3U, 4U}) {
    EXPECT_EQ(identify_modes(set_of(truth), {.modes = count}).size(), count);
  }
}

TEST(FittedStarts, RefuseAFitThatLeavesItsPlaceAndKeepTheOthers) {
  const std::vector<Pole> truth{{200, 0.01}, {780, 0.008}};
  const FrfDataset set = set_of(truth);
  const IdentifyOptions options{.start_Hz = {200, 900}};
  const std::vector<Mode> found = identify_modes(set, options);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].pole.freq_Hz, 200, 0.1);
  const std::vector<RefusedStart> refused = refused_starts(set, options);
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].asked_Hz, 900);
}

TEST(ModesFromPoles, LeaveOutAPoleThatTheFrfsDoNotShow) {
  const std::vector<Pole> truth{{200, 0.01}, {780, 0.008}};
  const std::vector<Mode> found =
      modes_from_poles(set_of(truth), {truth[0], {.freq_Hz = 1200, .damping_ratio = 0.01}, truth[1]}, Effort::standard);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[1].pole.freq_Hz, 780, 0.1);
}

}  // namespace percuss::identify::joint_search_test
