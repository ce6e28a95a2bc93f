#include "pipeline/warnings/deflection_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace percuss::pipeline::deflection_warnings_test {

const Warning* find(const std::vector<Warning>& warnings, const char* code) {
  const auto found = std::find_if(warnings.begin(), warnings.end(), [&](const auto& one) { return one.code == code; });
  return found == warnings.end() ? nullptr : &*found;
}

// The modal method with an effective mass lets a hung structure move away for ever.
TEST(DeflectionWarnings, SayThatAStructureIsNotFree) {
  metrics::Deflection free{.method = metrics::DeflectionMethod::modal};
  metrics::Deflection hung{
      .method = metrics::DeflectionMethod::modal, .larger_later = true, .rigid_motion_contradicted = true};
  const auto of = [](const metrics::Deflection& one) {
    return DeflectionResults::OfHit{.hit = 0, .deflection = &one, .onset_s = 0, .fs_Hz = 1000};
  };
  DeflectionResults test{.impacts = 2, .rest_recorded = true, .has_force = true, .mass_known = true};
  test.deflections = {of(free), of(free)};
  EXPECT_EQ(find(deflection_warnings(test), "not_free"), nullptr);
  test.deflections = {of(free), of(hung)};
  const std::vector<Warning> warnings = deflection_warnings(test);
  const Warning* found = find(warnings, "not_free");
  ASSERT_NE(found, nullptr);
  EXPECT_THAT(found->message, testing::HasSubstr("1 of 2 deflections do not move as a free body"));
  EXPECT_THAT(found->message, testing::HasSubstr("a suspension that pulls the structure back"));
  EXPECT_THAT(found->remedy, testing::HasSubstr("choose the method drift-free and leave the mass out"));
  EXPECT_EQ(find(warnings, "larger_later"), nullptr) << "not_free says so";
}

// A structure on a suspension must not get the advice to state a mass, which holds for a free structure alone.
TEST(DeflectionWarnings, AdviseAMassForStructuresThatAreFreeForTheWholeRecord) {
  const metrics::Deflection alone{.method = metrics::DeflectionMethod::modal, .rigid_motion_left_out = true};
  DeflectionResults test{.impacts = 1, .rest_recorded = true, .has_force = true};
  test.deflections = {{.hit = 0, .deflection = &alone, .onset_s = 0, .fs_Hz = 1000}};
  const std::vector<Warning> warnings = deflection_warnings(test);
  const Warning* found = find(warnings, "modes_alone");
  ASSERT_NE(found, nullptr);
  EXPECT_THAT(found->remedy, testing::HasSubstr("if nothing pulls it back within the record"));
  EXPECT_THAT(found->remedy, testing::HasSubstr("choose the method drift-free if the structure hangs"));
}

// The effective mass needs the force, and a mass that is stated already is no advice.
TEST(DeflectionWarnings, AdviseAMassOnlyWhereOneCanBeStated) {
  const metrics::Deflection drifting{
      .method = metrics::DeflectionMethod::drift_free, .peak_m = 1, .larger_later = true};
  for (const bool has_force : {true, false}) {
    for (const bool mass_known : {true, false}) {
      if (mass_known && !has_force) continue;
      DeflectionResults test{.impacts = 1, .rest_recorded = true, .has_force = has_force, .mass_known = mass_known};
      test.deflections = {{.hit = 0, .deflection = &drifting, .onset_s = 0, .fs_Hz = 1000}};
      const std::vector<Warning> warnings = deflection_warnings(test);
      const Warning *later = find(warnings, "larger_later"), *drift = find(warnings, "drift");
      ASSERT_TRUE(later != nullptr && drift != nullptr);
      const auto advises_mass = testing::HasSubstr("state its effective mass");
      const bool useful = has_force && !mass_known;
      EXPECT_EQ(testing::Value(later->remedy, advises_mass), useful);
      EXPECT_EQ(testing::Value(drift->remedy, advises_mass), useful);
      EXPECT_EQ(later->options.empty(), !useful);
    }
  }
}

// On a suspension, a free body's motion is not the measured one: the mass is no advice, --free-body is.
TEST(DeflectionWarnings, SayWhatHoldsForAHungStructure) {
  const metrics::Deflection drifting{.method = metrics::DeflectionMethod::drift_free, .peak_m = 1};
  for (const bool mass_known : {true, false}) {
    DeflectionResults test{.impacts = 1, .rest_recorded = true, .has_force = true, .mass_known = mass_known};
    test.deflections = {{.hit = 0, .deflection = &drifting, .onset_s = 0, .fs_Hz = 1000}};
    const std::vector<Warning> warnings = deflection_warnings(test);
    const Warning* drift = find(warnings, "drift");
    ASSERT_NE(drift, nullptr);
    EXPECT_THAT(drift->remedy, testing::HasSubstr("hangs on bands or strings"));
    EXPECT_THAT(drift->remedy, testing::HasSubstr("may move away"));
    EXPECT_THAT(drift->options, testing::Contains("free_body"));
  }
}

// A longer record helps while the structure swings; afterwards it adds noise alone.
TEST(DeflectionWarnings, AdviseTheEndOfARecordThatDrifts) {
  const metrics::Deflection drifting{.method = metrics::DeflectionMethod::drift_free, .peak_m = 1};
  for (const bool has_force : {true, false}) {
    DeflectionResults test{.impacts = 1, .rest_recorded = true, .has_force = has_force};
    test.deflections = {{.hit = 0, .deflection = &drifting, .onset_s = 0, .fs_Hz = 1000}};
    const std::vector<Warning> warnings = deflection_warnings(test);
    const Warning* drift = find(warnings, "drift");
    ASSERT_NE(drift, nullptr);
    EXPECT_THAT(drift->remedy, testing::HasSubstr("swings at the end, record longer"));
    EXPECT_THAT(drift->remedy, testing::HasSubstr("end the record before"));
    EXPECT_THAT(drift->options, testing::Contains("to"));
  }
}

}  // namespace percuss::pipeline::deflection_warnings_test
