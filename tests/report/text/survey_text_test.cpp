#include "report/text/survey_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

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

}  // namespace percuss::report::survey_text_test
