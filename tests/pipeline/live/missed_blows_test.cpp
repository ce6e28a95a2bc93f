#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "support/live/guide_bench.hpp"
#include "support/live/live_source.hpp"

namespace percuss::missed_blows_test {
namespace {

using acquire::RowMark;
using pipeline::GuideOptions;
using Bench = test::GuideBench;
using test::struck_tube;
using testing::ElementsAre;
using Kind = pipeline::SessionEvent::Kind;

constexpr const char* kFiveTimes = "0.4, 1.9, 3.4, 4.9, 6.4";
constexpr std::size_t kChannels = 3;
constexpr double kFs_Hz = 4096;

// The hammer's cable breaks, and only noise remains.
void cut_force(Bench& bench, double from_s) {
  for (auto frame = static_cast<std::size_t>(from_s * kFs_Hz); frame < bench.source.frames(); ++frame)
    bench.source.values[kChannels * frame] = 0.001 * std::sin(0.9 * static_cast<double>(frame));
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
  for (auto frame = static_cast<std::size_t>(3 * kFs_Hz); frame < static_cast<std::size_t>(4.5 * kFs_Hz); ++frame)
    for (std::size_t c = 0; c < kChannels; ++c) bench.source.values[kChannels * frame + c] *= 0.5;
  bench.play_all();
  EXPECT_EQ(bench.guide->session().accepted(), 4U);
  EXPECT_EQ(bench.witness.silent_hammers, 1U);
}

// No missed blow is reported for a motion that is much smaller than after a blow, during a pause, and while the sensor
// is on its way to the next point.
TEST(MissedBlows, AreNotReportedForHandling) {
  Bench weak(struck_tube(kFiveTimes, 8), {.plan = {.hits = 9}});
  cut_force(weak, 3);
  for (auto frame = static_cast<std::size_t>(3 * kFs_Hz); frame < weak.source.frames(); ++frame)
    for (std::size_t c = 1; c < kChannels; ++c) weak.source.values[kChannels * frame + c] *= 0.1;
  weak.play_all();
  EXPECT_EQ(weak.witness.silent_hammers, 0U);

  Bench paused(struck_tube(kFiveTimes, 8), {.plan = {.hits = 9}});
  cut_force(paused, 3);
  paused.play(0, static_cast<std::size_t>(3 * kFs_Hz));
  paused.guide->command(Kind::pause);
  paused.play(static_cast<std::size_t>(3 * kFs_Hz), paused.source.frames());
  EXPECT_EQ(paused.witness.silent_hammers, 0U);

  GuideOptions roving{.plan = {.points = {1, 2}, .hits = 2}};
  roving.sensor_moves = true;
  Bench moving(struck_tube(kFiveTimes, 8), std::move(roving));
  cut_force(moving, 3);
  moving.play_all();
  EXPECT_EQ(moving.witness.silent_hammers, 0U);
}

// While a blow is being recorded, the key to finish takes effect after the blow; a second press takes effect at once.
TEST(EndByKey, WaitsForTheBlowThatIsBeingRecorded) {
  for (const bool twice : {false, true}) {
    Bench bench(struck_tube(kFiveTimes, 8));
    bench.play(0, static_cast<std::size_t>(2 * kFs_Hz));  // in the second blow
    bench.guide->command(Kind::finish);
    EXPECT_FALSE(bench.guide->session().finished());
    EXPECT_TRUE(bench.guide->has_waiting_command());
    if (twice) bench.guide->command(Kind::finish);
    EXPECT_EQ(bench.guide->session().finished(), twice);
    bench.play(static_cast<std::size_t>(2 * kFs_Hz), static_cast<std::size_t>(3 * kFs_Hz));
    EXPECT_TRUE(bench.guide->session().finished());
    EXPECT_EQ(bench.guide->session().accepted(), twice ? 1U : 2U);
  }
  Bench quiet(struck_tube(kFiveTimes, 8));
  quiet.play(0, static_cast<std::size_t>(1.5 * kFs_Hz));
  quiet.guide->command(Kind::finish);
  EXPECT_TRUE(quiet.guide->session().finished());
}

TEST(StatedLength, IsNamedWhereTheNextBlowComesWithin) {
  GuideOptions options;
  options.length_s = 2;
  Bench bench(struck_tube(kFiveTimes, 8), std::move(options));
  bench.play_all();
  ASSERT_FALSE(bench.witness.blows.empty());
  EXPECT_EQ(bench.witness.blows[0].grade.mark, RowMark::struck_again);
  EXPECT_EQ(bench.witness.blows[0].grade.reason, "struck again within the stated length");
  EXPECT_EQ(bench.witness.blows[0].grade.remedy, "wait between blows, or shorten the length");
}

// An amplifier clips far below the converter's range. Once two blows show its level, all blows at it are clipped.
TEST(ClippedLevel, IsRememberedOnceTwoBlowsShowIt) {
  Bench bench(struck_tube("0.4, 1.9, 3.4, 4.9, 6.4, 7.9, 9.4", 11, R"("recorder": {"force_clip_n": 150})"),
              {.plan = {.hits = 9}});
  bench.play_all();
  const auto marks = bench.marks();
  ASSERT_EQ(marks.size(), 7U);
  EXPECT_EQ(bench.guide->session().accepted(), 0U);
  for (const RowMark mark : marks) EXPECT_EQ(mark, RowMark::force_overload);
}

}  // namespace
}  // namespace percuss::missed_blows_test
