#include "pipeline/warnings/object_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss::pipeline::object_warnings_test {

using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;

const std::vector<identify::ModeClassification> kTube{{.type = identify::ModeType::bending, .order = 1, .ratio = 0.5}};
const std::vector<identify::ModeClassification> kOther{{.order = 1}};

TEST(ObjectWarnings, SayNothingOfStatedAngles) {
  EXPECT_THAT(object_warnings(kTube, {.angles_assumed = false}), IsEmpty());
  EXPECT_THAT(object_warnings(kOther, {.angles_assumed = false}), IsEmpty());
  EXPECT_THAT(object_warnings({}, {.angles_assumed = true}), IsEmpty());
}

TEST(ObjectWarnings, SayThatAnglesWereAssumed) {
  EXPECT_THAT(object_warnings(kTube, {.angles_assumed = true}), ElementsAre(Field(&Warning::code, "assumed_tube")));
  EXPECT_THAT(object_warnings(kTube, {.object = identify::ObjectKind::tube, .angles_assumed = true}),
              ElementsAre(Field(&Warning::options, ElementsAre("angle"))));
}

TEST(ObjectWarnings, SayThatTheModesContradictATube) {
  EXPECT_THAT(object_warnings(kOther, {.angles_assumed = true}), ElementsAre(Field(&Warning::code, "not_a_tube")));
}

}  // namespace percuss::pipeline::object_warnings_test
