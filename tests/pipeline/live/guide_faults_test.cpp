#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "pipeline/live/guide.hpp"
#include "support/live/guide_bench.hpp"
#include "support/live/live_source.hpp"

// Faults of the capture, and blows that cannot be recorded.
namespace percuss::pipeline::guide_faults_test {

using acquire::RowMark;
using Bench = test::GuideBench;
using test::analysis_document, test::kTubeChannels, test::kTubeRate_Hz, test::struck_tube;
using testing::ElementsAre;

constexpr const char* kFiveTimes = "0.4, 1.9, 3.4, 4.9, 6.4";

// Lost samples, and samples that are no numbers, are reported between the verdicts on the blows, in the order of time.
TEST(GuideFaults, ReportsFaultsInTheOrderOfSamples) {
  const acquire::Record tube = struck_tube(kFiveTimes, 8);
  const auto play = [](Bench& bench, std::size_t block) {
    for (std::size_t i = 3000; i < 3200; ++i)
      bench.source.values[kTubeChannels * i + 2] = std::nan("");  // between the blows
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

// A device that is unplugged after the last blow does not concern the session.
TEST(GuideFaults, LeavesOutWhatHappensAfterTheLastBlow) {
  Bench bench(struck_tube(kFiveTimes, 8));
  bench.play(0, bench.source.frames());
  bench.guide->add_finding({.fault = acquire::CaptureFault::unplugged, .frame = bench.source.frames()});
  bench.guide->finish();
  EXPECT_TRUE(bench.witness.faults.empty());
  EXPECT_TRUE(bench.guide->record().faults.empty());
}

TEST(GuideFaults, StatesWhyFramesAreMissing) {
  Bench bench(struck_tube(kFiveTimes, 8));
  bench.guide->add_finding({.fault = acquire::CaptureFault::dropped, .frame = 8200, .count = 200});
  bench.play(0, 8000);
  bench.play(8200, bench.source.frames());
  bench.guide->finish();
  EXPECT_THAT(bench.guide->record().faults,
              ElementsAre(acquire::RecordFault{
                  .kind = acquire::FaultKind::dropped, .row = 1, .time_s = 8000 / kTubeRate_Hz, .value = 200}));
}

TEST(GuideFaults, KeepsTheFaultsOfAnInterruptedSession) {
  Bench bench(struck_tube(kFiveTimes, 8));
  // The journal's samples begin at frame 400. Of these three faults, they show the second gap only.
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

// The trigger needs only the force. A channel without numbers is named once, and the memory does not grow.
TEST(GuideFaults, NamesAChannelThatDeliversNoNumbers) {
  Bench bench(struck_tube(kFiveTimes, 8));
  for (std::size_t i = 2; i < bench.source.values.size(); i += kTubeChannels) bench.source.values[i] = std::nan("");
  bench.play_all();
  for (const RowMark mark : bench.marks()) EXPECT_EQ(mark, RowMark::no_numbers);
  ASSERT_EQ(bench.witness.blows.size(), 5U);
  EXPECT_EQ(bench.witness.blows[0].grade.reason, "channel 3 (accel 2) has values that are no numbers");
  ASSERT_EQ(bench.witness.faults.size(), 1U);
  EXPECT_EQ(bench.witness.faults[0].channel, 2U);
  Bench force(struck_tube(kFiveTimes, 8));
  for (std::size_t i = 0; i < force.source.values.size(); i += kTubeChannels) force.source.values[i] = std::nan("");
  force.play(0, force.source.frames());
  EXPECT_LT(force.guide->kept_frames(), 6000U);
  ASSERT_EQ(force.witness.faults.size(), 1U);
  EXPECT_EQ(force.witness.faults[0].channel, 0U);
}

// A blow that is followed by another within half a second cannot set the length. It is not recorded, but reported.
TEST(GuideFaults, SaysWhatItDoesNotRecord) {
  Bench bench(struck_tube("0.4, 0.7, 2.2, 3.7", 5));
  bench.play_all();
  EXPECT_EQ(bench.witness.left_out, 1U);
  EXPECT_EQ(bench.guide->session().blows().size(), 3U);
  Bench early(struck_tube("0.1, 1.9", 3));
  early.play_all();
  EXPECT_EQ(early.guide->session().blows().size(), 2U);
}

TEST(GuideFaults, MarksBlowsThatLostSamples) {
  Bench bench(struck_tube(kFiveTimes, 8));
  const std::size_t lost = 8000;  // in the second blow
  bench.play(0, lost);
  bench.play(lost + 200, bench.source.frames());
  bench.guide->finish();
  EXPECT_EQ(bench.witness.faults.size(), 1U);
  EXPECT_THAT(bench.marks(),
              ElementsAre(RowMark::none, RowMark::lost_samples, RowMark::none, RowMark::none, RowMark::none));
  const acquire::Record record = bench.guide->record();
  EXPECT_THAT(record.faults,
              ElementsAre(acquire::RecordFault{
                  .kind = acquire::FaultKind::gap, .row = 1, .time_s = lost / kTubeRate_Hz, .value = 200}));
  const std::string json = analysis_document(record);
  EXPECT_NE(json.find("capture_lost_samples"), std::string::npos);
  EXPECT_NE(json.find("rejected while it was recorded: samples were lost"), std::string::npos);
}

TEST(GuideFaults, DistinguishesTheEndOfTheRecordingFromALoss) {
  Bench bench(struck_tube(kFiveTimes, 8));
  bench.play(0, 8000);  // the second blow rings on
  bench.guide->finish();
  EXPECT_THAT(bench.marks(), ElementsAre(RowMark::none, RowMark::ended));
  EXPECT_EQ(bench.witness.blows[1].grade.reason, "the recording ended within the blow");
}

TEST(GuideFaults, GoesOnAfterALongGap) {
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

}  // namespace percuss::pipeline::guide_faults_test
