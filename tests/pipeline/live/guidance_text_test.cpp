#include "pipeline/live/guidance_text.hpp"

#include <gtest/gtest.h>

namespace percuss::pipeline::guidance_text_test {

using acquire::RowMark;
using Kind = SessionEvent::Kind;

LiveChannels two_responses() {
  LiveChannels channels;
  channels.accel = {1, 2};
  channels.accel_names = {"accel 1", "accel 2"};
  channels.accel_numbers = {2, 3};
  return channels;
}

TEST(GuidanceText, SaysWhereAndWhatAndWhatToDo) {
  const SessionPlan many{.points = {3, 5, 9}, .hits = 5}, one{.hits = 5};
  BlowReport blow{.row = 7, .point = 5, .blow = 3, .grade = {.peak_N = -312.4, .bandwidth_Hz = 4210}};
  EXPECT_EQ(blow_text(blow, two_responses(), many),
            "Point 5 (2 of 3), blow 3 of 5 (hit 8): accepted, 312 N up to 4.21 kHz");
  blow.point = 0;
  EXPECT_EQ(blow_text(blow, two_responses(), one), "Blow 3 of 5 (hit 8): accepted, 312 N up to 4.21 kHz");
  blow.grade.force_range = 0.94;
  EXPECT_EQ(blow_text(blow, two_responses(), one),
            "Blow 3 of 5 (hit 8): accepted, 312 N up to 4.21 kHz; hit a little softer (force at 94 % of range)");
  blow.grade.mark = RowMark::silent_channel;
  blow.grade.reason = "channel 3 is silent";
  blow.grade.remedy = "check its cable and its input";
  EXPECT_EQ(blow_text(blow, two_responses(), one),
            "Blow 3 of 5 (hit 8): rejected: channel 3 is silent; check its cable and its input");
}

TEST(GuidanceText, SetsTheRangeByTheFirstBlows) {
  const LiveChannels channels = two_responses();
  EXPECT_EQ(range_advice({.force_range = 0.12}, channels, true), "force peak at 12 % of full scale: raise the gain");
  EXPECT_EQ(range_advice({.force_range = 0.12}, channels, false), "");
  EXPECT_EQ(range_advice({.force_range = 0.5, .accel_range = 0.01, .accel_channel = 1}, channels, true),
            "channel 3 at 1 % of full scale: raise the gain");
  EXPECT_EQ(range_advice({.force_range = 0.5, .accel_range = 0.95, .accel_channel = 0}, channels, false),
            "hit a little softer (channel 2 at 95 % of range)");
  EXPECT_EQ(range_advice({}, channels, true), "");
}

TEST(GuidanceText, SaysWhyAPushIsNoBlow) {
  EXPECT_EQ(long_push_text({.peak = 1, .peak_N = -226.6, .length_s = 0.0562}, 61.04),
            "a push of 227 N and 56.2 ms, 61.0 s after the start, is no blow: a hammer's contact lasts 50 ms at most; "
            "strike shorter, or use a harder tip");
}

TEST(GuidanceText, PromptsForTheNextStep) {
  SessionState session({.points = {1, 2, 7}, .hits = 2});
  const auto prompt = [&] { return prompt_text(session, RovingPart::hammer); };
  EXPECT_EQ(prompt(), "move the hammer to point 1 of 3, then strike");
  session.apply({.kind = Kind::blow});
  EXPECT_EQ(prompt(), "strike: point 1 of 3, blow 2 of 2");
  session.apply({.kind = Kind::go_to, .point = 7});
  EXPECT_EQ(prompt(), "move the hammer to point 7 (3 of 3), then strike");
  EXPECT_EQ(prompt_text(session, RovingPart::sensor), "move the sensor to point 7 (3 of 3), then strike");
  session.apply({.kind = Kind::pause});
  EXPECT_EQ(prompt(), "paused; press space to go on");
  EXPECT_EQ(summary_text(session), "0 of 3 points complete; 1 blow counts, 0 rejected");
  session.apply({.kind = Kind::pause});
  session.apply({.kind = Kind::undo});
  session.apply({.kind = Kind::blow, .mark = RowMark::weak});
  session.apply({.kind = Kind::blow});
  session.apply({.kind = Kind::blow});
  session.apply({.kind = Kind::redo, .point = 1});
  session.apply({.kind = Kind::blow});
  EXPECT_EQ(summary_text(session), "0 of 3 points complete; 1 blow counts, 1 rejected, 3 undone");
}

TEST(GuidanceText, ShowsThePrecisionAndTheOutlook) {
  const SessionQuality quality{
      .blows = 4,
      .modes = {{.type = identify::ModeType::bending, .order = 1, .freq_Hz = 205.0471, .freq_std_Hz = 0.012},
                {.freq_Hz = 2012.3, .freq_std_Hz = 0.1, .falling_std_Hz = 0.1}},
      .coherence = 0.9984};
  EXPECT_EQ(quality_text(quality), "2 modes in Hz: bending 1 205.047 ± 0.012, 2012.30 ± 0.10; coherence 0.998");
  EXPECT_EQ(outlook_text(quality, {}), "12 more blows halve the ± of mode 2, 0.1 Hz");
  EXPECT_EQ(outlook_text(quality, parse_goals("mode 2<0.05Hz, hoop 1 < 1 Hz")),
            "12 more blows bring mode 2 below 0.05 Hz; hoop 1 < 1 Hz: not found yet");
  EXPECT_EQ(
      goals_text(quality, parse_goals("mode 2<0.05Hz, hoop 1 < 1 Hz, mode 1<1Hz")),
      "the goal mode 2 < 0.05 Hz is not met, ± 0.1 Hz; the goal hoop 1 < 1 Hz is not met: no such mode was found; "
      "the goal mode 1 < 1 Hz is met, ± 0.012 Hz");
  EXPECT_EQ(quality_text({.blows = 1}), "1 blow, no modes yet");
  // The digits of the ± and of the value go together, as in the tables of an analysis.
  EXPECT_EQ(
      quality_text(
          {.blows = 2, .modes = {{.freq_Hz = 178.49841, .freq_std_Hz = 9e-5}, {.freq_Hz = 2300, .freq_std_Hz = 12}}}),
      "2 modes in Hz: 178.498410 ± 0.000090, 2300 ± 12");
}

}  // namespace percuss::pipeline::guidance_text_test
