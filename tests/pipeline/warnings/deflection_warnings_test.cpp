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
  EXPECT_THAT(found->remedy, testing::HasSubstr("free for the whole record"));
  EXPECT_THAT(found->remedy, testing::HasSubstr("choose the method drift-free"));
}

}  // namespace percuss::pipeline::deflection_warnings_test
