#include "pipeline/warnings/point_force_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pipeline/warnings/ranking.hpp"

namespace percuss::pipeline::point_force_warnings_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr std::size_t kPoints = 12, kHitsPerPoint = 3;

// A survey with a hammer held by hand: the forces of the hits differ by a factor of 8. The responses per newton differ
// by a factor of 6 between the points.
struct GradedTest {
  acquire::Record record;
  std::vector<AnalysedHit> hits;

  void scale(int point, double force, double response) {
    for (AnalysedHit& hit : hits) {
      if (hit.point != point) continue;
      hit.hit.peak_N *= force;
      for (acquire::ResponseGrade& grade : hit.responses) {
        grade.extremes.low *= response;
        grade.extremes.high *= response;
      }
    }
  }
};

GradedTest survey(std::size_t points = kPoints, bool file_for_each_point = true) {
  GradedTest test;
  for (std::size_t p = 0; p < points; ++p) {
    if (file_for_each_point || p == 0) test.record.files.push_back({.path = "p" + std::to_string(p) + ".csv"});
    for (std::size_t h = 0; h < kHitsPerPoint; ++h) {
      const auto turn = static_cast<double>(p * kHitsPerPoint + h);
      const double peak_N = 200 * std::exp(std::log(8.0) / 2 * std::sin(2.4 * turn));
      const double range_mps2 = peak_N * std::exp(std::log(6.0) / 2 * std::sin(1.7 * static_cast<double>(p)));
      AnalysedHit hit{.hit = {.row = test.hits.size(), .peak_N = peak_N},
                      .point = static_cast<int>(p),
                      .accepted = true,
                      .responses = {}};
      for (const double gain : {1.0, 0.3})
        hit.responses.push_back({.extremes = {.low = -0.4 * gain * range_mps2, .high = 0.6 * gain * range_mps2}});
      test.hits.push_back(std::move(hit));
      test.record.rows.push_back({.file = file_for_each_point ? p : 0, .point = static_cast<int>(p)});
    }
  }
  return test;
}

std::vector<Warning> warnings_of(const GradedTest& test) {
  return point_force_warnings(test.record, test.hits, PointNames(test.record, test.record.points()));
}

TEST(PointForceWarnings, SayNothingOfHitsByHand) {
  EXPECT_THAT(warnings_of(survey()), IsEmpty());
  EXPECT_THAT(warnings_of(survey(1)), IsEmpty());
  EXPECT_THAT(point_force_warnings({}, {}, {}), IsEmpty());
}

TEST(PointForceWarnings, NameTheFileWhoseForceIsInAnotherUnit) {
  GradedTest test = survey();
  test.scale(5, 1e-3, 1);
  const std::vector<Warning> warnings = warnings_of(test);
  ASSERT_THAT(warnings, ElementsAre(AllOf(Field(&Warning::code, "units_differ"),
                                          Field(&Warning::options, ElementsAre("force_scale")))));
  EXPECT_THAT(warnings[0].message, StartsWith("the force of the hits at point 5 (p5.csv) is "));
  EXPECT_THAT(warnings[0].message, HasSubstr("times smaller than at the other points, but the responses are not"));
  EXPECT_THAT(warnings[0].message, HasSubstr("kN for N"));
  EXPECT_EQ(severity_of("units_differ"), acquire::Severity::reject);
}

// A sensitivity of 22.5 mV/N is not stated at a few points: their force is in V, not in N.
TEST(PointForceWarnings, NameAMissingSensitivity) {
  GradedTest test = survey();
  for (const int point : {2, 3, 9}) test.scale(point, 0.0225, 1);
  const std::vector<Warning> warnings = warnings_of(test);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0].message,
              AllOf(StartsWith("the force of the hits at points 2 (p2.csv), 3 (p3.csv), 9 (p9.csv) is "),
                    HasSubstr("V for N")));
}

TEST(PointForceWarnings, NameTheSmallerGroupWhereItsForceIsLarger) {
  GradedTest test = survey();
  for (int point = 1; point < static_cast<int>(kPoints); ++point) test.scale(point, 1e-3, 1);
  const std::vector<Warning> warnings = warnings_of(test);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0].message, AllOf(HasSubstr("at point 0 (p0.csv) is "), HasSubstr("times larger")));
}

TEST(PointForceWarnings, AskForAFileInOneUnitWhereThereIsOneFile) {
  GradedTest test = survey(kPoints, false);
  test.scale(5, 1e-3, 1);
  const std::vector<Warning> warnings = warnings_of(test);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0].options, IsEmpty());
  EXPECT_THAT(warnings[0].message, AllOf(HasSubstr("at point 5 is "), Not(HasSubstr("(p0.csv)"))));
}

TEST(PointForceWarnings, CallHitsWeakWhoseResponsesAreWeakToo) {
  GradedTest test = survey();
  test.scale(5, 0.004, 0.004);
  EXPECT_THAT(warnings_of(test), ElementsAre(AllOf(Field(&Warning::code, "weak"),
                                                   Field(&Warning::message, HasSubstr("at point 5 (p5.csv)")))));
  GradedTest harder = survey();
  harder.scale(5, 250, 250);  // a sledge hammer at a foundation
  EXPECT_THAT(warnings_of(harder), IsEmpty());
}

// A force in lbf in place of N looks like a soft blow at a place that moves much.
TEST(PointForceWarnings, CannotTellASmallFactorFromSoftBlows) {
  GradedTest test = survey();
  test.scale(5, 1 / 4.448, 1);
  EXPECT_THAT(warnings_of(test), IsEmpty());
}

TEST(PointForceWarnings, SayNothingOfForcesWithoutAGap) {
  GradedTest test = survey();
  for (int point = 0; point < static_cast<int>(kPoints); ++point) test.scale(point, std::pow(2.0, -point), 1);
  EXPECT_THAT(warnings_of(test), IsEmpty());
}

TEST(PointForceWarnings, NeedResponses) {
  GradedTest test = survey();
  test.scale(5, 1e-3, 1);
  for (AnalysedHit& hit : test.hits) hit.responses.clear();
  EXPECT_THAT(warnings_of(test), IsEmpty());
}

TEST(PointForceWarnings, IgnoreHitsThatAreNotUsedAndOffsets) {
  GradedTest test = survey();
  for (AnalysedHit& hit : test.hits) {
    for (acquire::ResponseGrade& grade : hit.responses) {
      grade.extremes.low += 1e6;
      grade.extremes.high += 1e6;
    }
  }
  test.scale(5, 1e-3, 1);
  EXPECT_THAT(warnings_of(test), ElementsAre(Field(&Warning::code, "units_differ")));
  for (AnalysedHit& hit : test.hits) hit.accepted = hit.point != 5;
  EXPECT_THAT(warnings_of(test), IsEmpty());
}

constexpr double kPulse_s = 1e-3;

// Four bending modes of a free beam at the points of survey(), without noise; `force` is the factor by which the force
// at one point is wrong, so that its residues are wrong by 1/force.
std::vector<identify::Mode> beam_modes(int point, double force, double std = 1e-3) {
  std::vector<identify::Mode> modes(4);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    for (std::size_t p = 0; p < kPoints; ++p) {
      const double x = static_cast<double>(p) / (kPoints - 1);
      const double scale = static_cast<int>(p) == point ? 1 / force : 1;
      modes[m].residues.push_back(
          {.point = p, .value = scale * std::cos(std::numbers::pi * static_cast<double>(m + 2) * x), .std = std});
    }
  }
  return modes;
}

// The survey with the forces, the responses and the pulse lengths at one point multiplied by these factors.
GradedTest survey_of_force(int point, double force, double response, double pulse) {
  GradedTest test = survey();
  for (AnalysedHit& hit : test.hits) hit.hit.pulse_s = hit.point == point ? pulse * kPulse_s : kPulse_s;
  test.record.force.to_SI = 0.5;
  test.scale(point, force, response);
  return test;
}

std::vector<Warning> range_warnings_of(const GradedTest& test, const std::vector<identify::Mode>& modes) {
  return point_range_warnings(test.record, test.hits, modes, PointNames(test.record, test.record.points()));
}

TEST(PointRangeWarnings, NameAPointWhoseForceIsWrongByTen) {
  for (const int point : {0, 3, 7, 11}) {
    const std::vector<Warning> small = range_warnings_of(survey_of_force(point, 0.1, 1, 1), beam_modes(point, 0.1));
    ASSERT_EQ(small.size(), 1U) << point;
    EXPECT_EQ(small[0].code, "units_differ");
    EXPECT_THAT(small[0].options, ElementsAre("force_scale"));
    EXPECT_THAT(small[0].message,
                AllOf(StartsWith("the force of the hits at point " + std::to_string(point) + " (p" +
                                 std::to_string(point) + ".csv) is about "),
                      HasSubstr("times smaller"), HasSubstr("5 for the files of this point, 0.5 for")));
    const std::vector<Warning> large = range_warnings_of(survey_of_force(point, 10, 1, 1), beam_modes(point, 10));
    ASSERT_EQ(large.size(), 1U) << point;
    EXPECT_THAT(large[0].message, AllOf(HasSubstr("times larger"), HasSubstr("0.05 for the files of this point")));
  }
}

TEST(PointRangeWarnings, SayNothingOfSoftAndHardBlows) {
  EXPECT_THAT(range_warnings_of(survey_of_force(3, 1, 1, 1), beam_modes(3, 1)), IsEmpty());
  for (const int point : {0, 3, 7, 11}) {
    EXPECT_THAT(range_warnings_of(survey_of_force(point, 0.1, 0.1, 1), beam_modes(point, 1)), IsEmpty()) << point;
    EXPECT_THAT(range_warnings_of(survey_of_force(point, 10, 10, 1), beam_modes(point, 1)), IsEmpty()) << point;
  }
}

// A thin part that moves much takes little force, in a long pulse.
TEST(PointRangeWarnings, SayNothingOfASoftPlace) {
  EXPECT_THAT(range_warnings_of(survey_of_force(3, 0.1, 1, 2), beam_modes(3, 0.1)), IsEmpty());
}

TEST(PointRangeWarnings, NeedModesAboveTheNoiseAndUsualPoints) {
  std::vector<identify::Mode> noise = beam_modes(3, 0.1);
  for (identify::Mode& mode : noise) {
    for (identify::Residue& residue : mode.residues) {
      if (residue.point == 3) residue.std = std::abs(residue.value) / 3;
    }
  }
  EXPECT_THAT(range_warnings_of(survey_of_force(3, 0.1, 1, 1), noise), IsEmpty());
  std::vector<identify::Mode> two = beam_modes(3, 0.1);
  two.resize(2);
  EXPECT_THAT(range_warnings_of(survey_of_force(3, 0.1, 1, 1), two), IsEmpty());
  GradedTest uneven = survey_of_force(3, 0.1, 1, 1);  // half of the points are struck softly
  for (int point = 6; point < static_cast<int>(kPoints); ++point) uneven.scale(point, 0.1, 0.1);
  EXPECT_THAT(range_warnings_of(uneven, beam_modes(3, 0.1)), IsEmpty());
}

}  // namespace percuss::pipeline::point_force_warnings_test
