#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "support/live/guide_bench.hpp"
#include "support/live/live_source.hpp"

namespace percuss::pipeline::first_blows_test {

using acquire::RowMark;
using Bench = test::GuideBench;
using test::kTubeChannels, test::kTubeRate_Hz, test::struck_tube;
using testing::ElementsAre, testing::HasSubstr;

// Fewer samples precede the first blow than the later ones.
TEST(FirstBlows, GivesRowsTheirDecayAfterAnEarlyFirstBlow) {
  GuideOptions options;
  options.pretrigger_s = 1;
  Bench bench(struck_tube("0.3, 4, 8", 12), std::move(options));
  bench.play_all();
  EXPECT_THAT(bench.marks(), ElementsAre(RowMark::none, RowMark::none, RowMark::none));
  // The slowest mode falls by 52 dB in 0.4 s.
  EXPECT_GT(static_cast<double>(bench.guide->length().value_or(0)), (1 + 0.4) * kTubeRate_Hz);
  Bench early(struck_tube("0.01, 4, 8", 12));
  early.play_all();
  EXPECT_EQ(early.witness.left_out, 1U);
  EXPECT_THAT(early.marks(), ElementsAre(RowMark::none, RowMark::none));
}

// Two blows do not show which of them is weak.
TEST(FirstBlows, TakesOutWeakFirstBlowsOnceThereAreThree) {
  for (const std::size_t weak : {0U, 1U}) {
    const std::string faults = R"("faults": [{"hit": )" + std::to_string(weak) + R"(, "kind": "weak", "ratio": 0.05}])";
    Bench bench(struck_tube("0.4, 1.9, 3.4, 4.9", 7, faults));
    bench.play_all();
    EXPECT_EQ(bench.marks()[weak], RowMark::weak) << weak;
    EXPECT_EQ(bench.guide->session().accepted(), 3U) << weak;
    EXPECT_EQ(bench.witness.blows[1].may_advise_gain, weak == 0);  // no gain is raised for the weaker of two blows
  }
}

// An undamped structure rings before the next blow: its channel is alive.
TEST(FirstBlows, TellsRingingFromASilentChannel) {
  Bench bench(struck_tube("0.4, 2, 3.6", 6));
  for (std::size_t i = 1640; i < bench.source.frames(); ++i) {
    for (std::size_t c = 1; c < kTubeChannels; ++c)
      bench.source.values[kTubeChannels * i + c] +=
          50 * std::sin(2 * std::numbers::pi * 151.37 * static_cast<double>(i) / kTubeRate_Hz);
  }
  bench.play_all();
  ASSERT_EQ(bench.marks().size(), 3U);
  for (std::size_t blow = 1; blow < bench.marks().size(); ++blow)
    EXPECT_EQ(bench.marks()[blow], RowMark::still_ringing) << bench.witness.blows[blow].grade.reason;
}

// The hammer touches lightly 50 ms before the blow, outside the samples that are kept of the blow.
TEST(FirstBlows, SeesContactsBeforeTheSamples) {
  Bench bench(struck_tube("0.4, 1.9, 3.4", 5));
  for (std::size_t i = 0; i < 3; ++i) {
    const double part = 0.3 * std::pow(std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / 3), 2);
    bench.source.values[kTubeChannels * (static_cast<std::size_t>(1.85 * kTubeRate_Hz) + i)] += 300 * part;
  }
  bench.play_all();
  EXPECT_THAT(bench.marks(), ElementsAre(RowMark::none, RowMark::double_hit, RowMark::none));
  EXPECT_THAT(bench.witness.blows[1].grade.reason, HasSubstr("the first"));
  EXPECT_THAT(bench.witness.blows[1].grade.reason, HasSubstr("50 ms before it"));
}

}  // namespace percuss::pipeline::first_blows_test
