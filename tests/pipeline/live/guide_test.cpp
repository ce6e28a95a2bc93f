#include "pipeline/live/guide.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>

#include "acquire/hits/hits.hpp"
#include "support/live/guide_bench.hpp"
#include "support/live/live_source.hpp"

namespace percuss::pipeline::guide_test {

using acquire::RowMark;
using Bench = test::GuideBench;
using test::analysis_document, test::force_rows, test::kTubeChannels, test::kTubeRate_Hz, test::struck_tube;
using testing::ElementsAre;
using Kind = SessionEvent::Kind;

constexpr const char* kFiveTimes = "0.4, 1.9, 3.4, 4.9, 6.4";

TEST(Guide, RecordsTheAskedBlows) {
  Bench bench(struck_tube("0.4, 1.9, 3.4, 4.9, 6.4, 7.9", 9.5));
  bench.play_all();
  EXPECT_TRUE(bench.guide->session().finished());
  EXPECT_EQ(bench.guide->session().accepted(), 5U);
  const acquire::Record record = bench.guide->record();
  ASSERT_EQ(record.rows.size(), 5U);
  EXPECT_TRUE(record.faults.empty());
  // The chosen length covers the whole decay: the slowest mode falls by 52 dB in 0.4 s.
  EXPECT_GE(record.rows[0].samples, 1600U);
  EXPECT_LT(record.rows[0].samples, 4096U);
  const std::string json = analysis_document(record);
  for (const char* expected : {R"("family": "hoop")", R"("family": "bending")"})
    EXPECT_NE(json.find(expected), std::string::npos) << json;
  EXPECT_EQ(json.find("truncated_decay"), std::string::npos);
}

TEST(Guide, DoesNotDependOnTheSizeOfTheBlocks) {
  const acquire::Record tube = struck_tube("0.01, 1.5, 1.62, 3, 4.5, 5.8", 7);
  Bench whole(tube);
  whole.play_all(1U << 20U);
  for (const std::size_t block : {1U, 7U, 64U, 777U, 4096U}) {
    Bench bench(tube);
    bench.play_all(block);
    EXPECT_EQ(bench.log.events, whole.log.events) << block;
    EXPECT_EQ(force_rows(bench.guide->record()), force_rows(whole.guide->record())) << block;
  }
}

// Blows that begin shortly before or after the end of the previous blow's samples, wherever the blocks are divided.
TEST(Guide, JudgesBlowsInQuickSuccessionAlikeForAnyBlocks) {
  for (const char* times_s : {"0.4, 0.85, 2, 2.7, 4", "0.4, 1.1, 1.55, 2.9", "0.4, 0.95, 1.5, 2.02, 2.6"}) {
    const acquire::Record tube = struck_tube(times_s, 5);
    Bench whole(tube);
    whole.play_all(1U << 20U);
    EXPECT_GE(whole.log.events.size(), 3U);
    for (const std::size_t block : {1U, 7U, 64U, 4096U}) {
      Bench bench(tube);
      bench.play_all(block);
      EXPECT_EQ(bench.log.events, whole.log.events) << times_s << " in blocks of " << block;
      EXPECT_EQ(force_rows(bench.guide->record()), force_rows(whole.guide->record())) << times_s << block;
    }
  }
}

TEST(Guide, RejectsBlowsAndSaysWhatToDo) {
  Bench bench(struck_tube("0.4, 1.9, 3.4, 4.9, 6.4, 7.9, 9.4, 10.9", 13,
                          R"("faults": [{"hit": 2, "kind": "double", "delay_s": 0.012, "ratio": 0.4},
                                        {"hit": 4, "kind": "weak", "ratio": 0.06}])"));
  bench.play_all();
  EXPECT_THAT(bench.marks(), ElementsAre(RowMark::none, RowMark::none, RowMark::double_hit, RowMark::none,
                                         RowMark::weak, RowMark::none, RowMark::none));
  EXPECT_EQ(bench.witness.blows[2].grade.remedy, "strike shorter: let the hammer bounce off");
  EXPECT_EQ(bench.witness.blows[4].grade.remedy, "hit harder");
  EXPECT_EQ(bench.witness.blows[3].blow, 3U);
}

TEST(Guide, RejectsClippedForcesAndResponses) {
  Bench force(struck_tube(kFiveTimes, 8, R"("recorder": {"force_clip_n": 220})"));
  force.play_all();
  EXPECT_THAT(force.marks(), testing::Contains(RowMark::force_overload));
  Bench accel(struck_tube(kFiveTimes, 8, R"("recorder": {"accel_clip_mps2": 100})"));
  accel.play_all();
  ASSERT_FALSE(accel.marks().empty());
  for (const RowMark mark : accel.marks()) EXPECT_EQ(mark, RowMark::response_overload);
  EXPECT_EQ(accel.guide->session().accepted(), 0U);
}

TEST(Guide, RejectsBlowsInTheDecayOfTheLast) {
  Bench bench(struck_tube("0.4, 1.9, 2.05, 3.6, 5.1", 7));
  bench.play_all();
  EXPECT_THAT(bench.marks(),
              ElementsAre(RowMark::none, RowMark::struck_again, RowMark::still_ringing, RowMark::none, RowMark::none));
  EXPECT_EQ(bench.witness.blows[1].grade.reason, "struck again before the decay ended");
}

// A push that is too long for a blow is reported, at most once a second. It shows that the hammer is not silent.
TEST(Guide, ReportsPushesThatAreTooLong) {
  Bench bench(struck_tube("2.9, 4.4", 7));
  const auto push = [&](double at_s, double length_s, double peak_N) {
    const auto first = static_cast<std::size_t>(at_s * kTubeRate_Hz),
               count = static_cast<std::size_t>(length_s * kTubeRate_Hz);
    for (std::size_t i = 0; i < count; ++i) {
      const double phase = std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
      bench.source.values[kTubeChannels * (first + i)] += peak_N * std::pow(std::sin(phase), 2);
      bench.source.values[kTubeChannels * (first + i) + 1] += i % 2 == 0 ? 30 : -30;
    }
  };
  push(0.5, 0.08, 300);
  push(1.2, 0.07, 200);  // within a second of the first: not reported
  push(2.0, 0.6, 250);   // a hand that leans on the hammer
  push(5.4, 0.08, 9);    // weak: no attempt to strike
  push(6.2, 0.15, 300);
  bench.play_all();
  ASSERT_EQ(bench.witness.long_pushes.size(), 2U);
  EXPECT_NEAR(bench.witness.long_pushes[0].peak_N, 300, 1);
  // sin² exceeds 5 % on 86 % of its length
  EXPECT_NEAR(bench.witness.long_pushes[0].length_s, 0.86 * 0.08, 0.002);
  EXPECT_NEAR(bench.witness.long_pushes[1].length_s, 0.86 * 0.15, 0.002);
  EXPECT_EQ(bench.witness.silent_hammers, 0U);
  EXPECT_EQ(bench.guide->session().accepted(), 2U);
}

TEST(Guide, RejectsBlowsWithinWhichAResponseDropsOut) {
  Bench bench(struck_tube(kFiveTimes, 8));
  std::vector<double>& values = bench.source.values;
  for (std::size_t i = 0; i < 200; ++i)
    values[kTubeChannels * (static_cast<std::size_t>(1.93 * kTubeRate_Hz) + i) + 2] = 0;
  bench.play_all();
  EXPECT_THAT(bench.marks(),
              ElementsAre(RowMark::none, RowMark::silent_channel, RowMark::none, RowMark::none, RowMark::none));
  EXPECT_EQ(bench.witness.blows[1].grade.reason, "channel 3 (accel 2) drops out for 48.8 ms");
}

// At a low rate, the samples that are searched together last for seconds.
TEST(Guide, AcceptsCleanBlowsAtLowRates) {
  for (const double fs_Hz : {50.0, 200.0, 256.0, 500.0}) {
    acquire::Record record = struck_tube("0.4, 1.9, 3.4, 4.9, 6.4", 9);
    record.fs_Hz = fs_Hz;  // the same samples, in slow motion
    Bench bench(record);
    bench.play_all();
    for (const RowMark mark : bench.marks()) EXPECT_EQ(mark, RowMark::none) << fs_Hz;
    EXPECT_EQ(bench.guide->session().accepted(), 5U) << fs_Hz;
  }
}

TEST(Guide, RejectsASilentChannel) {
  Bench bench(struck_tube(kFiveTimes, 8));
  std::vector<double>& values = bench.source.values;
  for (std::size_t i = 2; i < values.size(); i += kTubeChannels) values[i] = 0.25;
  bench.play_all();
  for (const RowMark mark : bench.marks()) EXPECT_EQ(mark, RowMark::silent_channel);
  EXPECT_EQ(bench.witness.blows[0].grade.reason, "channel 3 (accel 2) is silent");
}

TEST(Guide, JudgesTheRangeByFullScale) {
  Bench bench(struck_tube(kFiveTimes, 8));
  bench.source.format.full_scale = 320;
  bench.guide = std::make_unique<Guide>(bench.source.format, live_channels(bench.source.format, {}),
                                        GuideOptions{.folder = testing::TempDir()}, bench.log, bench.witness);
  bench.play_all();
  ASSERT_FALSE(bench.witness.blows.empty());
  for (const BlowReport& blow : bench.witness.blows) {
    EXPECT_NEAR(blow.grade.force_range.value_or(0), std::abs(blow.grade.peak_N) / 320, 0.01);
    EXPECT_EQ(blow.grade.mark == RowMark::force_overload, blow.grade.force_range > 0.999);
  }
}

// The guide accepts and rejects the same blows as the analysis of the finished record.
TEST(Guide, AgreesWithTheAnalysis) {
  Bench bench(struck_tube("0.4, 1.9, 3.4, 4.9, 6.4, 7.9, 9.4, 10.9", 13,
                          R"("faults": [{"hit": 2, "kind": "double", "delay_s": 0.012, "ratio": 0.4},
                                        {"hit": 4, "kind": "weak", "ratio": 0.06}])"));
  bench.play_all();
  const Analysis analysis(bench.guide->record(), {});
  const auto& hits = analysis.hits();
  ASSERT_EQ(hits.size(), bench.guide->session().blows().size());
  for (std::size_t h = 0; h < hits.size(); ++h)
    EXPECT_EQ(hits[h].accepted, bench.guide->session().blows()[h].accepted()) << h;
}

TEST(Guide, AppliesCommandsAfterTheBlowsBeforeThem) {
  Bench bench(struck_tube(kFiveTimes, 8), {.plan = {.points = {0, 1, 2}, .hits = 2}});
  bench.play(0, 2000);  // the first blow is being collected
  bench.guide->command(Kind::next);
  bench.play(2000, bench.source.frames());
  bench.guide->finish();
  const auto& blows = bench.guide->session().blows();
  ASSERT_EQ(blows.size(), 5U);
  EXPECT_THAT((std::vector{blows[0].point, blows[1].point, blows[2].point, blows[3].point, blows[4].point}),
              ElementsAre(0, 1, 1, 2, 2));
}

TEST(Guide, LeavesOutBlowsWhilePaused) {
  Bench bench(struck_tube(kFiveTimes, 8));
  bench.play(0, 6000);
  bench.guide->command(Kind::pause);
  bench.play(6000, 18000);
  bench.guide->command(Kind::pause);
  bench.play(18000, bench.source.frames());
  bench.guide->finish();
  EXPECT_EQ(bench.guide->session().blows().size(), 3U);
}

TEST(Guide, StopsWhenTheGoalIsMet) {
  GuideOptions options{.plan = {.hits = 50}, .until = parse_goals("hoop1<0.5Hz")};
  Bench bench(struck_tube(kFiveTimes, 8), std::move(options));
  bench.play_all();
  EXPECT_EQ(bench.witness.goals, 1U);
  EXPECT_TRUE(bench.guide->session().finished());
  EXPECT_LT(bench.guide->session().accepted(), 5U);
}

// Each row has 20 samples before its pulse, fewer than the pretrigger.
TEST(Guide, TakesRowsThatBeginShortlyBeforeTheirPulses) {
  constexpr std::size_t kRow = 5600, kPause = 4096, kBefore = 20;
  test::LiveSource source(struck_tube("0.4, 1.9, 3.4, 4.9, 6.4", 8));
  source.format.pause_frames = kPause;
  test::MemoryLog log;
  test::GuideRecorder witness;
  Guide guide(source.format, live_channels(source.format, {}), {.plan = {.hits = 5}, .folder = testing::TempDir()}, log,
              witness);
  for (std::size_t row = 0; row < 5; ++row) {
    const auto pulse = static_cast<std::size_t>((0.4 + 1.5 * static_cast<double>(row)) * kTubeRate_Hz);
    acquire::SampleBlock block = source.block(pulse - kBefore, kRow);
    block.first_frame = row * (kRow + kPause);
    guide.take(std::move(block));
  }
  guide.finish();
  EXPECT_EQ(guide.session().accepted(), 5U);
  EXPECT_TRUE(witness.faults.empty());
  EXPECT_TRUE(guide.record().faults.empty());
}

// A blow 0.3 s after the one before it. The response needs 0.4 s to decay by 52 dB.
TEST(Guide, RejectsABlowOnAStructureThatStillRings) {
  Bench bench(struck_tube("0.4, 1.9, 2.2, 3.7", 5), {.length_s = 0.25});
  bench.play_all();
  EXPECT_THAT(bench.marks(), ElementsAre(RowMark::none, RowMark::none, RowMark::still_ringing, RowMark::none));
}

// "r" undoes the blows of the point where it was pressed, including the blow that is being recorded.
TEST(Guide, RepeatsThePointOfTheBlowBeingRecorded) {
  Bench bench(struck_tube(kFiveTimes, 8), {.plan = {.points = {3, 7}, .hits = 1}});
  bench.play(0, 1800);  // in the first blow
  bench.guide->command(Kind::redo, bench.guide->session().point());
  EXPECT_TRUE(bench.guide->has_waiting_command());
  bench.play(1800, 4096);
  EXPECT_EQ(bench.marks().front(), RowMark::redone);
  EXPECT_EQ(bench.guide->session().point(), 3);
  EXPECT_THAT(bench.witness.undone, ElementsAre(1));
  bench.guide->command(Kind::undo);
  bench.guide->finish();
  EXPECT_EQ(bench.witness.undone.back(), 0U) << "nothing is left to undo";
}

TEST(Guide, ReportsASilentHammer) {
  Bench bench(struck_tube(kFiveTimes, 8));
  for (std::size_t i = 0; i < bench.source.values.size(); i += kTubeChannels)
    bench.source.values[i] = 0.001 * std::sin(0.9 * static_cast<double>(i));
  bench.play_all();
  EXPECT_EQ(bench.witness.silent_hammers, 1U);
  Bench sound(struck_tube(kFiveTimes, 8));
  sound.play_all();
  EXPECT_EQ(sound.witness.silent_hammers, 0U);
}

TEST(Guide, GivesRowsTheirDecayAfterALongPretrigger) {
  Bench bench(struck_tube("1.4, 2.9, 4.4", 6), {.pretrigger_s = 1});
  bench.play_all();
  ASSERT_EQ(bench.guide->session().accepted(), 3U);
  EXPECT_GT(bench.guide->record().rows[0].samples, 4096U + 1600U);
}

// While a blow is being recorded, the key to finish takes effect after the blow; a second press takes effect at once.
TEST(Guide, EndsByKeyAfterTheBlowThatIsBeingRecorded) {
  for (const bool twice : {false, true}) {
    Bench bench(struck_tube(kFiveTimes, 8));
    bench.play(0, static_cast<std::size_t>(2 * kTubeRate_Hz));  // in the second blow
    bench.guide->command(Kind::finish);
    EXPECT_FALSE(bench.guide->session().finished());
    EXPECT_TRUE(bench.guide->has_waiting_command());
    if (twice) bench.guide->command(Kind::finish);
    EXPECT_EQ(bench.guide->session().finished(), twice);
    bench.play(static_cast<std::size_t>(2 * kTubeRate_Hz), static_cast<std::size_t>(3 * kTubeRate_Hz));
    EXPECT_TRUE(bench.guide->session().finished());
    EXPECT_EQ(bench.guide->session().accepted(), twice ? 1U : 2U);
  }
  Bench quiet(struck_tube(kFiveTimes, 8));
  quiet.play(0, static_cast<std::size_t>(1.5 * kTubeRate_Hz));
  quiet.guide->command(Kind::finish);
  EXPECT_TRUE(quiet.guide->session().finished());
}

TEST(Guide, NamesTheStatedLengthWhereTheNextBlowComesWithin) {
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
TEST(Guide, RemembersAClippedLevelOnceTwoBlowsShowIt) {
  Bench bench(struck_tube("0.4, 1.9, 3.4, 4.9, 6.4, 7.9, 9.4", 11, R"("recorder": {"force_clip_n": 150})"),
              {.plan = {.hits = 9}});
  bench.play_all();
  const auto marks = bench.marks();
  ASSERT_EQ(marks.size(), 7U);
  EXPECT_EQ(bench.guide->session().accepted(), 0U);
  for (const RowMark mark : marks) EXPECT_EQ(mark, RowMark::force_overload);
}

// A session that is killed at any frame, and resumed from the samples and events that it left, ends as if nothing had
// happened.
TEST(Guide, ResumesToTheSameRecord) {
  const acquire::Record tube =
      struck_tube("0.4, 1.9, 3.4, 4.9, 6.4, 7.9, 9.4", 11,
                  R"("faults": [{"hit": 2, "kind": "double", "delay_s": 0.012, "ratio": 0.4}])");
  const GuideOptions options{.plan = {.points = {0, 1}, .hits = 2}};
  const auto play = [&](Bench& bench, std::size_t first, std::size_t last) {
    if (first <= 9000 && 9000 < last) {
      bench.play(first, 9000);
      bench.guide->command(Kind::undo);
      first = 9000;
    }
    bench.play(first, last);
  };
  Bench whole(tube, options);
  play(whole, 0, whole.source.frames());
  whole.guide->finish();
  EXPECT_TRUE(whole.guide->session().finished());
  const auto expected = force_rows(whole.guide->record());
  for (const std::size_t killed : {500U, 1700U, 3000U, 8999U, 9001U, 9100U, 15000U, 21000U, 27001U}) {
    for (const bool by_signal : {false, true}) {
      SCOPED_TRACE(testing::Message() << killed << (by_signal ? " by a signal" : " by a kill"));
      Bench first(tube, options);
      play(first, 0, killed);
      if (by_signal) first.guide->finish();
      Bench second(tube, options);
      std::vector<SessionEvent> events;
      for (const std::string& event : first.log.events) events.push_back(parse_session_event(event, "test"));
      second.guide->resume_from(events);
      second.play(0, killed, 4096);  // the journal's blocks are longer
      play(second, killed, second.source.frames());
      second.guide->finish();
      EXPECT_EQ(second.marks(), whole.marks());
      EXPECT_EQ(force_rows(second.guide->record()), expected);
      // The second log continues the first. Joined, they equal the log of the uninterrupted session.
      std::vector<std::string> log = first.log.events;
      log.insert(log.end(), second.log.events.begin(), second.log.events.end());
      EXPECT_EQ(log, whole.log.events);
    }
  }
}

}  // namespace percuss::pipeline::guide_test
