#include "pipeline/live/guide.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "acquire/hits/hits.hpp"
#include "pipeline/run_analyses.hpp"
#include "report/json/analysis_json.hpp"
#include "support/live_source.hpp"

namespace percuss::guide_test {
namespace {

using acquire::RowMark;
using pipeline::BlowReport, pipeline::Guide, pipeline::GuideOptions, pipeline::SessionEvent;
using test::LiveSource, test::MemoryLog, test::struck_tube;
using testing::ElementsAre;
using Kind = SessionEvent::Kind;

struct Witness : pipeline::GuideObserver {
  std::vector<BlowReport> blows;
  std::vector<std::size_t> regraded;
  std::vector<acquire::CaptureFinding> faults;
  std::vector<std::string> order;  // what was told: "blow at 1638", "gap at 8000"
  std::size_t left_out = 0, goals = 0;
  void on_blow(const BlowReport& blow) override {
    blows.push_back(blow);
    order.push_back("blow " + std::to_string(blow.row + 1));
  }
  void on_regraded(std::size_t row, RowMark /*mark*/) override { regraded.push_back(row); }
  void on_fault(const acquire::CaptureFinding& fault) override {
    faults.push_back(fault);
    order.emplace_back(acquire::fault_name(fault.fault));
  }
  void on_left_out(std::uint64_t /*frame*/) override { ++left_out; }
  void on_goals_met() override { ++goals; }
};

struct Bench {
  LiveSource source;
  MemoryLog log;
  Witness witness;
  std::unique_ptr<Guide> guide;

  explicit Bench(const acquire::Record& record, GuideOptions options = {}, acquire::ReadOptions read = {})
      : source(record) {
    options.folder = testing::TempDir();
    guide = std::make_unique<Guide>(source.format, pipeline::live_channels(source.format, read), std::move(options),
                                    log, witness);
  }
  void play(std::size_t first, std::size_t last, std::size_t block = 400) const {
    for (std::size_t at = first; at < last; at += block) guide->take(source.block(at, std::min(block, last - at)));
  }
  void play_all(std::size_t block = 400) const {
    play(0, source.frames(), block);
    guide->finish();
  }
  std::vector<RowMark> marks() const {
    std::vector<RowMark> out;
    for (const auto& blow : guide->session().blows()) out.push_back(blow.mark);
    return out;
  }
};

std::string json_of(acquire::Record record) {
  std::vector<acquire::Record> records;
  records.push_back(std::move(record));
  const auto runs = pipeline::analyses_of_runs(std::move(records), {});
  return report::analysis_json(*runs.front().analysis);
}

std::vector<std::vector<double>> force_rows(const acquire::Record& record) {
  std::vector<std::vector<double>> rows;
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    rows.emplace_back(record.rows[row].samples);
    record.read_force_N(row, 0, rows.back());
  }
  return rows;
}

constexpr const char* kFiveTimes = "0.4, 1.9, 3.4, 4.9, 6.4";

TEST(Guide, RecordsTheAskedBlows) {
  Bench bench(struck_tube("0.4, 1.9, 3.4, 4.9, 6.4, 7.9", 9.5));
  bench.play_all();
  EXPECT_TRUE(bench.guide->session().finished());
  EXPECT_EQ(bench.guide->session().accepted(), 5U);
  const acquire::Record record = bench.guide->record();
  ASSERT_EQ(record.rows.size(), 5U);
  EXPECT_TRUE(record.faults.empty());
  // The length was chosen until the decay has ended: the slowest mode falls by 52 dB in 0.4 s.
  EXPECT_GE(record.rows[0].samples, 1600U);
  EXPECT_LT(record.rows[0].samples, 4096U);
  const std::string json = json_of(record);
  for (const char* expected : {"\"family\": \"hoop\"", "\"family\": \"bending\""})
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

// A blow that begins shortly before or after the end of the last one's samples, at any place between two blocks.
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

// Losses, and samples that are no numbers, are told between the verdicts where they happened.
TEST(Guide, TellsFaultsInTheOrderOfSamples) {
  const acquire::Record tube = struck_tube(kFiveTimes, 8);
  const auto play = [](Bench& bench, std::size_t block) {
    for (std::size_t i = 3000; i < 3200; ++i) bench.source.values[3 * i + 2] = std::nan("");  // between the blows
    const std::size_t lost = 8000, last = bench.source.frames();
    bench.play(0, lost, block);  // in the second blow
    bench.play(lost + 200, last, block);
    bench.guide->add_finding({.fault = acquire::CaptureFault::unplugged, .frame = last});
    bench.guide->finish();
  };
  Bench whole(tube, {.plan = {.hits = 9}});
  play(whole, 1U << 20U);
  EXPECT_THAT(whole.witness.order,
              ElementsAre("blow 1", "not_a_number", "blow 2", "gap", "blow 3", "blow 4", "blow 5", "unplugged"));
  const auto faults = whole.guide->record().faults;
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_EQ(faults[0].kind, acquire::FaultKind::not_a_number);
  EXPECT_EQ(faults[0].value, 200);
  EXPECT_EQ(faults[2].kind, acquire::FaultKind::unplugged);
  for (const std::size_t block : {1U, 7U, 64U, 4096U}) {
    Bench bench(tube, {.plan = {.hits = 9}});
    play(bench, block);
    EXPECT_EQ(bench.witness.order, whole.witness.order) << block;
    EXPECT_EQ(bench.guide->record().faults, faults) << block;
    EXPECT_EQ(bench.log.events, whole.log.events) << block;
  }
}

// The device's end after the last blow does not concern the session, however late or early it is noticed.
TEST(Guide, LeavesOutWhatHappensAfterTheLastBlow) {
  Bench bench(struck_tube(kFiveTimes, 8));
  bench.play(0, bench.source.frames());
  bench.guide->add_finding({.fault = acquire::CaptureFault::unplugged, .frame = bench.source.frames()});
  bench.guide->finish();
  EXPECT_TRUE(bench.witness.faults.empty());
  EXPECT_TRUE(bench.guide->record().faults.empty());
}

TEST(Guide, StatesWhyFramesAreMissing) {
  Bench bench(struck_tube(kFiveTimes, 8));
  bench.guide->add_finding({.fault = acquire::CaptureFault::dropped, .frame = 8200, .count = 200});
  bench.play(0, 8000);
  bench.play(8200, bench.source.frames());
  bench.guide->finish();
  EXPECT_THAT(bench.guide->record().faults,
              ElementsAre(acquire::RecordFault{
                  .kind = acquire::FaultKind::dropped, .row = 1, .time_s = 8000 / 4096.0, .value = 200}));
}

TEST(Guide, KeepsTheFaultsOfAnInterruptedSession) {
  Bench bench(struck_tube(kFiveTimes, 8));
  // The journal's samples begin at frame 400; two faults were before, one is in its samples.
  bench.guide->resume_from({},
                           {{.fault = acquire::CaptureFault::gap, .frame = 300, .count = 100},
                            {.fault = acquire::CaptureFault::gap, .frame = 8200, .count = 200},
                            {.fault = acquire::CaptureFault::unplugged, .frame = 9000}},
                           400);
  bench.play(400, 8000);
  bench.play(8200, 9000);
  bench.guide->add_finding({.fault = acquire::CaptureFault::resumed, .frame = 9000});
  bench.play(9400, bench.source.frames());
  bench.guide->finish();
  std::vector<acquire::FaultKind> kinds;
  for (const auto& fault : bench.guide->record().faults) kinds.push_back(fault.kind);
  using enum acquire::FaultKind;
  EXPECT_THAT(kinds, ElementsAre(gap, gap, unplugged, resumed));
}

// The trigger needs the force alone; the dead channel is named, once, and its memory stays flat.
TEST(Guide, NamesAChannelThatDeliversNoNumbers) {
  Bench bench(struck_tube(kFiveTimes, 8));
  for (std::size_t i = 2; i < bench.source.values.size(); i += 3) bench.source.values[i] = std::nan("");
  bench.play_all();
  for (const RowMark mark : bench.marks()) EXPECT_EQ(mark, RowMark::lost_samples);
  ASSERT_EQ(bench.witness.blows.size(), 5U);
  EXPECT_EQ(bench.witness.blows[0].grade.reason, "channel 3 (accel 2) has values that are no numbers");
  ASSERT_EQ(bench.witness.faults.size(), 1U);
  EXPECT_EQ(bench.witness.faults[0].channel, 2U);
  Bench force(struck_tube(kFiveTimes, 8));
  for (std::size_t i = 0; i < force.source.values.size(); i += 3) force.source.values[i] = std::nan("");
  force.play(0, force.source.frames());
  EXPECT_LT(force.guide->kept_frames(), 6000U);
  ASSERT_EQ(force.witness.faults.size(), 1U);
  EXPECT_EQ(force.witness.faults[0].channel, 0U);
}

// Two blows within half a second give no length; neither vanishes without a word.
TEST(Guide, SaysWhatItDoesNotRecord) {
  Bench bench(struck_tube("0.4, 0.7, 2.2, 3.7", 5));
  bench.play_all();
  EXPECT_EQ(bench.witness.left_out, 1U);
  EXPECT_EQ(bench.guide->session().blows().size(), 3U);
  Bench early(struck_tube("0.1, 1.9", 3));
  early.play_all();
  EXPECT_EQ(early.guide->session().blows().size(), 2U);
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
  for (const RowMark mark : accel.marks()) EXPECT_EQ(mark, RowMark::response_overload);
  EXPECT_EQ(accel.guide->session().accepted(), 0U);
}

TEST(Guide, RejectsBlowsInTheDecayOfTheLast) {
  Bench bench(struck_tube("0.4, 1.9, 2.05, 3.6, 5.1", 7));
  bench.play_all();
  EXPECT_THAT(bench.marks(),
              ElementsAre(RowMark::none, RowMark::still_ringing, RowMark::still_ringing, RowMark::none, RowMark::none));
  EXPECT_EQ(bench.witness.blows[1].grade.reason, "struck again before the decay ended");
}

TEST(Guide, RejectsASilentChannel) {
  Bench bench(struck_tube(kFiveTimes, 8));
  std::vector<double>& values = bench.source.values;
  for (std::size_t i = 2; i < values.size(); i += 3) values[i] = 0.25;
  bench.play_all();
  for (const RowMark mark : bench.marks()) EXPECT_EQ(mark, RowMark::silent_channel);
  EXPECT_EQ(bench.witness.blows[0].grade.reason, "channel 3 (accel 2) is silent");
}

TEST(Guide, MarksBlowsThatLostSamples) {
  Bench bench(struck_tube(kFiveTimes, 8));
  const std::size_t lost = 8000;  // in the second blow
  bench.play(0, lost);
  bench.play(lost + 200, bench.source.frames());
  bench.guide->finish();
  EXPECT_EQ(bench.witness.faults.size(), 1U);
  EXPECT_THAT(bench.marks(),
              ElementsAre(RowMark::none, RowMark::lost_samples, RowMark::none, RowMark::none, RowMark::none));
  const acquire::Record record = bench.guide->record();
  EXPECT_THAT(record.faults, ElementsAre(acquire::RecordFault{
                                 .kind = acquire::FaultKind::gap, .row = 1, .time_s = lost / 4096.0, .value = 200}));
  const std::string json = json_of(record);
  EXPECT_NE(json.find("capture_lost_samples"), std::string::npos);
  EXPECT_NE(json.find("rejected while it was recorded: samples were lost"), std::string::npos);
}

TEST(Guide, GoesOnAfterALongGap) {
  Bench bench(struck_tube(kFiveTimes, 8));
  bench.play(0, 7000);
  for (std::size_t at = 7000; at < bench.source.frames(); at += 400) {
    acquire::SampleBlock block = bench.source.block(at, 400);
    block.first_frame += std::uint64_t{1} << 40U;  // years
    bench.guide->take(std::move(block));
  }
  bench.guide->finish();
  EXPECT_EQ(bench.guide->session().accepted(), 5U);
}

TEST(Guide, JudgesTheRangeByFullScale) {
  Bench bench(struck_tube(kFiveTimes, 8));
  bench.source.format.full_scale = 320;
  bench.guide = std::make_unique<Guide>(bench.source.format, pipeline::live_channels(bench.source.format, {}),
                                        GuideOptions{.folder = testing::TempDir()}, bench.log, bench.witness);
  bench.play_all();
  for (const BlowReport& blow : bench.witness.blows) {
    EXPECT_NEAR(blow.grade.force_range.value_or(0), std::abs(blow.grade.peak_N) / 320, 0.01);
    EXPECT_EQ(blow.grade.mark == RowMark::force_overload, blow.grade.force_range > 0.999);
  }
}

// The verdicts of the bench are those of the analysis afterwards.
TEST(Guide, AgreesWithTheAnalysis) {
  Bench bench(struck_tube("0.4, 1.9, 3.4, 4.9, 6.4, 7.9, 9.4, 10.9", 13,
                          R"("faults": [{"hit": 2, "kind": "double", "delay_s": 0.012, "ratio": 0.4},
                                        {"hit": 4, "kind": "weak", "ratio": 0.06}])"));
  bench.play_all();
  const pipeline::Analysis analysis(bench.guide->record(), {});
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
  GuideOptions options{.plan = {.hits = 50}, .until = pipeline::parse_goals("hoop1<0.5Hz")};
  Bench bench(struck_tube(kFiveTimes, 8), std::move(options));
  bench.play_all();
  EXPECT_EQ(bench.witness.goals, 1U);
  EXPECT_TRUE(bench.guide->session().finished());
  EXPECT_LT(bench.guide->session().accepted(), 5U);
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
    Bench first(tube, options);
    play(first, 0, killed);
    Bench second(tube, options);
    std::vector<SessionEvent> events;
    for (const std::string& event : first.log.events) events.push_back(pipeline::parse_session_event(event, "test"));
    second.guide->resume_from(events);
    second.play(0, killed, 4096);  // the journal's blocks are longer
    play(second, killed, second.source.frames());
    second.guide->finish();
    EXPECT_EQ(second.marks(), whole.marks()) << killed;
    EXPECT_EQ(force_rows(second.guide->record()), expected) << killed;
    // The log goes on where it was: together they are the log of the whole.
    std::vector<std::string> log = first.log.events;
    log.insert(log.end(), second.log.events.begin(), second.log.events.end());
    EXPECT_EQ(log, whole.log.events) << killed;
  }
}

}  // namespace
}  // namespace percuss::guide_test
