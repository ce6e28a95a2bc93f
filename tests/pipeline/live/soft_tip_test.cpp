#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/live/guide.hpp"
#include "support/live/guide_bench.hpp"
#include "synth/read_spec.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::soft_tip_test {

using Bench = test::GuideBench;

// A floor with a mode at 20 Hz, struck three times with a soft tip. `width_s` is the length of the pulses.
acquire::Record floor_at(double fs_Hz, double width_s) {
  return synth::synthesise(synth::parse_synth_spec(fmt::format(
                                                       R"({{"schema": "percuss/synth/1", "name": "floor", "fs_hz": {},
      "duration_s": 11, "layout": "continuous", "hits": 3, "hit_times_s": [1, 4, 7], "band_hz": [5, 45],
      "structure": {{"rigid_line_per_kg": [0]}},
      "modes": [{{"frequency_hz": 20, "damping_ratio": 0.04, "residue_per_kg": [0.02]}}],
      "sensors": [{{"position_m": 0}}], "impact": {{"position_m": 0}},
      "pulse": {{"kind": "haversine", "width_s": {}, "peak_n": 300}}, "noise": {{"force": 1e-4, "accel": 1e-4}}}})",
                                                       fs_Hz, width_s),
                                                   "test"))
      .record;
}

struct Tip {
  double fs_Hz, width_s;
};

class SoftTip : public testing::TestWithParam<Tip> {};

TEST_P(SoftTip, GivesCleanBlows) {
  Bench bench(floor_at(GetParam().fs_Hz, GetParam().width_s));
  bench.play_all();
  ASSERT_EQ(bench.witness.blows.size(), 3U);
  for (const auto& blow : bench.witness.blows) EXPECT_TRUE(blow.grade.accepted()) << blow.grade.reason;
  // The mode falls by 52 dB in 1.2 s, and rings above its noise a little longer.
  EXPECT_GT(static_cast<double>(bench.guide->length().value_or(0)), 1.2 * GetParam().fs_Hz);
  for (const acquire::Hit& hit : acquire::find_hits(bench.guide->record()))
    EXPECT_FALSE(acquire::rejects(hit.findings));
}

INSTANTIATE_TEST_SUITE_P(LengthsAndRates, SoftTip,
                         testing::Values(Tip{500, 0.02}, Tip{6400, 0.04}, Tip{12800, 0.02}, Tip{12800, 0.03},
                                         Tip{25600, 0.01}, Tip{25600, 0.012}, Tip{25600, 0.014}, Tip{51200, 0.01}),
                         [](const auto& tip) {
                           return fmt::format("{:.0f}Hz{:.0f}ms", tip.param.fs_Hz, 1e3 * tip.param.width_s);
                         });

TEST(SoftTip, ThatBeginsBeforeTheSamplesIsNoSilentChannel) {
  GuideOptions options;
  options.pretrigger_s = 0.004;
  Bench bench(floor_at(12800, 0.02), std::move(options));
  bench.play_all();
  ASSERT_FALSE(bench.witness.blows.empty());
  for (const auto& blow : bench.witness.blows)
    EXPECT_EQ(blow.grade.reason, "the samples begin within the pulse") << blow.grade.remedy;
}

}  // namespace percuss::pipeline::soft_tip_test
