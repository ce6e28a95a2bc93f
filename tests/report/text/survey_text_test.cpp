#include "report/text/survey_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/survey.hpp"
#include "support/text_parts.hpp"
#include "synth/read_spec.hpp"
#include "synth/synthesise.hpp"

namespace percuss::report::survey_text_test {

using testing::HasSubstr;
using testing::Not;

/// The text of a survey of a plate with this many hits at each point.
std::string text_with_hits(std::size_t hits) {
  synth::SynthSpec spec = synth::synth_preset("plate");
  spec.hits = hits;
  const pipeline::Analysis analysis(synth::synthesise(spec).record,
                                    {.band_Hz = std::pair{40.0, 250.0}, .modes = {.effort = identify::Effort::quick}});
  return survey_text(pipeline::Survey(analysis, {}), false, 100);
}

// The scatter between the hits of a point holds the errors of their place and direction; one hit shows none.
TEST(SurveyText, StatesWhatTheStdOfOneHitPerPointLeavesOut) {
  const std::string sentence = "one hit per point: each ± leaves out errors of the place and direction of the hits";
  EXPECT_THAT(text_with_hits(1), HasSubstr(sentence));
  EXPECT_THAT(text_with_hits(2), Not(HasSubstr(sentence)));
}

// Modes that the user does not list explain their part of the FRFs.
TEST(SurveyText, JudgesTheFrfsWithTheModesThatAreNotListed) {
  const acquire::Record record = synth::synthesise(synth::synth_preset("plate")).record;
  const auto text = [&](std::optional<std::size_t> modes) {
    const pipeline::Analysis analysis(
        record, {.band_Hz = std::pair{40.0, 250.0}, .modes = {.effort = identify::Effort::quick, .modes = modes}});
    const std::string all = survey_text(pipeline::Survey(analysis, {}), false, 100);
    return test::between(all, "FRFs synthesised from the modes", "\n");
  };
  const std::string all = text(std::nullopt), one = text(1);
  EXPECT_THAT(all, testing::StartsWith(": lowest FRAC of the strong FRFs 0.99"));
  EXPECT_THAT(one, testing::StartsWith(" and the "));
  EXPECT_THAT(one, testing::EndsWith(" not listed" + all));
}

// A driving point whose residues are negative is known, but gives no scale.
TEST(SurveyText, SaysWhyADrivingPointGivesNoScale) {
  synth::SynthSpec spec = synth::synth_preset("plate");
  const auto reason = [&](double sign, std::vector<identify::DrivingPoint> driving) {
    spec.sensors.at(0).sign = sign;
    acquire::Record record = synth::synthesise(spec).record;
    record.driving.clear();
    record.geometry.clear();  // no position shows a driving point
    const pipeline::Analysis analysis(
        record, {.band_Hz = std::pair{40.0, 250.0}, .modes = {.effort = identify::Effort::quick}});
    const std::string all = survey_text(pipeline::Survey(analysis, {.driving = std::move(driving)}), false, 100);
    return test::between(all, "shapes: ", "\n");
  };
  const std::string none = "scaled to 1 at their largest component, because ";
  EXPECT_EQ(reason(1, {}), none + "no driving point is known");
  EXPECT_THAT(reason(1, {{.point = 0}}), testing::StartsWith("unit modal mass"));
  EXPECT_THAT(reason(-1, {{.point = 0}}),
              testing::AllOf(testing::StartsWith(none + "the residues at the driving point "),
                             testing::EndsWith("have the wrong sign")));
}

}  // namespace percuss::report::survey_text_test
