#include "report/text/survey_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/survey.hpp"
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

}  // namespace percuss::report::survey_text_test
