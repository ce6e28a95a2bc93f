#include "pipeline/live/until.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"

namespace percuss::pipeline::until_test {

using identify::ModeType;
using testing::HasSubstr;

TEST(Until, ReadsNamesNumbersAndUnits) {
  const auto goals = parse_goals("hoop1<0.05Hz, Bending 2 <= 0.1 %,mode 12<1e-1 hz");
  ASSERT_EQ(goals.size(), 3U);
  EXPECT_EQ(goals[0].type, ModeType::hoop);
  EXPECT_EQ(goals[0].number, 1);
  EXPECT_EQ(goals[0].limit, 0.05);
  EXPECT_EQ(goals[0].text(), "hoop 1 < 0.05 Hz");
  EXPECT_TRUE(goals[1].relative);
  EXPECT_DOUBLE_EQ(goals[1].limit, 0.001);
  EXPECT_EQ(goals[1].text(), "bending 2 < 0.1 %");
  EXPECT_EQ(goals[2].type, ModeType::unknown);
  EXPECT_EQ(goals[2].text(), "mode 12 < 0.1 Hz");
}

TEST(Until, SaysWhatItDoesNotUnderstand) {
  const auto problem_of = [](const char* text) -> std::string {
    try {
      parse_goals(text);
    } catch (const InputError& error) {
      EXPECT_THAT(error.options(), testing::ElementsAre("until"));
      return error.problem();
    }
    return "none";
  };
  EXPECT_THAT(problem_of(""), HasSubstr("no goal"));
  EXPECT_THAT(problem_of("hoop1<0.05Hz,"), HasSubstr("no goal"));
  EXPECT_THAT(problem_of("torsion1<1Hz"), HasSubstr("does not begin with"));
  EXPECT_THAT(problem_of("hoop<1Hz"), HasSubstr("number"));
  EXPECT_THAT(problem_of("hoop0<1Hz"), HasSubstr("number"));
  EXPECT_THAT(problem_of("hoop1>1Hz"), HasSubstr("'<'"));
  EXPECT_THAT(problem_of("hoop1<-1Hz"), HasSubstr("above 0"));
  EXPECT_THAT(problem_of("hoop1<nanHz"), HasSubstr("above 0"));
  EXPECT_THAT(problem_of("hoop1<1"), HasSubstr("no unit"));
  EXPECT_THAT(problem_of("hoop1<1kHz"), HasSubstr("not Hz or %"));
}

// Both modes of a split pair have one name.
TEST(Until, HoldsForBothModesOfASplitPair) {
  const SessionQuality quality{.blows = 4,
                               .modes = {{.type = ModeType::hoop, .order = 1, .freq_Hz = 1900, .freq_std_Hz = 0.01},
                                         {.type = ModeType::hoop, .order = 1, .freq_Hz = 1912, .freq_std_Hz = 0.06}}};
  const auto met = [&](const char* goals) { return all_met(parse_goals(goals), quality); };
  EXPECT_FALSE(met("hoop 1 < 0.05 Hz"));
  EXPECT_TRUE(met("hoop 1 < 0.07 Hz"));
  EXPECT_TRUE(met("mode 1 < 0.05 Hz"));
  EXPECT_EQ(mode_of(parse_goals("hoop 1 < 0.05 Hz").front(), quality), 1U);
}

TEST(Until, IsMetWhenEveryModeIsKnownWellEnough) {
  SessionQuality quality{.blows = 4,
                         .modes = {{.type = ModeType::bending, .order = 1, .freq_Hz = 200, .freq_std_Hz = 0.01},
                                   {.type = ModeType::hoop, .order = 1, .freq_Hz = 2000, .freq_std_Hz = 0.06}}};
  const auto met = [&](const char* goals) { return all_met(parse_goals(goals), quality); };
  EXPECT_TRUE(met("bending 1 < 0.02 Hz"));
  EXPECT_TRUE(met("hoop 1 < 0.004 %"));
  EXPECT_FALSE(met("hoop 1 < 0.05 Hz"));
  EXPECT_FALSE(met("bending1<0.02Hz,hoop1<0.05Hz"));
  EXPECT_FALSE(met("hoop 2 < 100 Hz"));  // not found
  EXPECT_TRUE(met("mode 2 < 0.07 Hz"));
  quality.blows = 2;  // their scatter may be chance
  EXPECT_FALSE(met("mode 2 < 0.07 Hz"));
  quality.blows = 4;
  quality.modes[1].freq_std_Hz = 0;  // one blow: not known
  EXPECT_FALSE(met("mode 2 < 0.07 Hz"));
}

// Of the variance after n₀ blows, the part b falls with the number n of blows: σ² = a + b·n₀/n.
TEST(FurtherBlows, FollowFromTheFallingPart) {
  const LiveMode noisy{.freq_std_Hz = 0.1, .falling_std_Hz = 0.1};
  EXPECT_EQ(further_blows(noisy, 4, 0.05), 12U);  // a quarter of the variance: 16 blows
  EXPECT_EQ(further_blows(noisy, 4, 0.1), 0U);
  EXPECT_EQ(further_blows(noisy, 4, 0.0999), 1U);
  const LiveMode mixed{.freq_std_Hz = 0.05, .falling_std_Hz = 0.04};  // 0.03 Hz stay
  EXPECT_EQ(further_blows(mixed, 5, 0.034), 27U);                     // 5·0.0016/0.000256 = 31.25
  EXPECT_FALSE(further_blows(mixed, 5, 0.03).has_value());
}

}  // namespace percuss::pipeline::until_test
