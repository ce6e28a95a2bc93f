#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "support/live/guide_bench.hpp"
#include "support/live/live_source.hpp"

namespace percuss::pipeline::missed_blows_test {

using Bench = test::GuideBench;
using test::kTubeChannels;
using test::kTubeRate_Hz;
using test::struck_tube;
using Kind = SessionEvent::Kind;

constexpr const char* kFiveTimes = "0.4, 1.9, 3.4, 4.9, 6.4";

// The hammer's cable breaks, and only noise remains.
void cut_force(Bench& bench, double from_s) {
  for (auto frame = static_cast<std::size_t>(from_s * kTubeRate_Hz); frame < bench.source.frames(); ++frame)
    bench.source.values[kTubeChannels * frame] = 0.001 * std::sin(0.9 * static_cast<double>(frame));
}

TEST(MissedBlows, AreReportedAfterOtherBlows) {
  Bench bench(struck_tube(kFiveTimes, 8), {.plan = {.hits = 9}});
  cut_force(bench, 3);
  bench.play_all();
  EXPECT_EQ(bench.guide->session().accepted(), 2U);
  EXPECT_EQ(bench.witness.silent_hammers, 3U);
}

TEST(MissedBlows, AreReportedBelowATriggerLevel) {
  GuideOptions options{.plan = {.hits = 9}};
  options.trigger_N = 150;
  Bench bench(struck_tube(kFiveTimes, 8), std::move(options));
  for (auto frame = static_cast<std::size_t>(3 * kTubeRate_Hz); frame < static_cast<std::size_t>(4.5 * kTubeRate_Hz);
       ++frame)
    for (std::size_t c = 0; c < kTubeChannels; ++c) bench.source.values[kTubeChannels * frame + c] *= 0.5;
  bench.play_all();
  EXPECT_EQ(bench.guide->session().accepted(), 4U);
  EXPECT_EQ(bench.witness.silent_hammers, 1U);
}

// No missed blow is reported for a motion that is much smaller than after a blow, during a pause, and while the sensor
// is on its way to the next point.
TEST(MissedBlows, AreNotReportedForHandling) {
  Bench weak(struck_tube(kFiveTimes, 8), {.plan = {.hits = 9}});
  cut_force(weak, 3);
  for (auto frame = static_cast<std::size_t>(3 * kTubeRate_Hz); frame < weak.source.frames(); ++frame)
    for (std::size_t c = 1; c < kTubeChannels; ++c) weak.source.values[kTubeChannels * frame + c] *= 0.1;
  weak.play_all();
  EXPECT_EQ(weak.witness.silent_hammers, 0U);

  Bench paused(struck_tube(kFiveTimes, 8), {.plan = {.hits = 9}});
  cut_force(paused, 3);
  paused.play(0, static_cast<std::size_t>(3 * kTubeRate_Hz));
  paused.guide->command(Kind::pause);
  paused.play(static_cast<std::size_t>(3 * kTubeRate_Hz), paused.source.frames());
  EXPECT_EQ(paused.witness.silent_hammers, 0U);

  GuideOptions roving{.plan = {.points = {1, 2}, .hits = 2}};
  roving.sensor_moves = true;
  Bench moving(struck_tube(kFiveTimes, 8), std::move(roving));
  cut_force(moving, 3);
  moving.play_all();
  EXPECT_EQ(moving.witness.silent_hammers, 0U);
}

}  // namespace percuss::pipeline::missed_blows_test
