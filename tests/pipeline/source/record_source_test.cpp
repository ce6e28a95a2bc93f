#include "pipeline/source/record_source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "pipeline/analysis.hpp"
#include "support/messages.hpp"
#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::record_source_test {

using testing::Contains;
using testing::Not;

constexpr double kLow_Hz = 40, kHigh_Hz = 2400, kFreq_Hz = 90, kDamping = 0.02;

synth::SynthSpec two_modes(double duration_s, std::size_t hits) {
  synth::SynthSpec spec =
      test::bat_spec({{.freq_Hz = kFreq_Hz, .damping_ratio = kDamping, .order = 1, .amplitude_per_sqrt_kg = 1.0},
                      {.freq_Hz = 1900,
                       .damping_ratio = 0.01,
                       .type = synth::SynthModeType::hoop,
                       .order = 1,
                       .amplitude_per_sqrt_kg = 2.4}},
                     duration_s);
  spec.hits = hits;
  spec.noise = {.force = 1e-4, .accel = 1e-4};
  return spec;
}

synth::SynthSpec several_in_a_row(double duration_s, std::size_t hits) {
  synth::SynthSpec spec = two_modes(duration_s, hits);
  spec.layout = synth::SynthLayout::continuous;
  return spec;
}

// 50 Hz and its third harmonic.
acquire::Record with_hum(acquire::Record record, double size_mps2) {
  record.contiguous.clear();
  record.read_accel_mps2 = [read = std::move(record.read_accel_mps2), fs_Hz = record.fs_Hz, size_mps2](
                               std::size_t row, std::size_t channel, std::size_t first, std::span<double> out) {
    read(row, channel, first, out);
    const double phase = static_cast<double>(row) + 2 * static_cast<double>(channel);
    for (std::size_t n = 0; n < out.size(); ++n) {
      const double turns = 50.02 / fs_Hz * static_cast<double>(first + n);
      out[n] += size_mps2 * (std::sin(kTwoPi * turns + phase) + 0.3 * std::sin(kTwoPi * 3 * turns + 2 * phase));
    }
  };
  return record;
}

// Each row as a record of its own, joined, as several files of one hit each are.
acquire::Record of_single_rows(const synth::SynthSpec& spec) {
  std::vector<acquire::Record> records;
  for (std::size_t h = 0; h < spec.hits; ++h) {
    synth::SynthSpec one = spec;
    one.hits = 1;
    one.seed = h;
    records.push_back(synth::synthesise(one).record);
  }
  return acquire::join_records(std::move(records), acquire::FileGrouping::hits);
}

Analysis analysis_of(acquire::Record record) {
  return {std::move(record), {.band_Hz = std::pair{kLow_Hz, kHigh_Hz}, .threads = 1}};
}

double used_s(const Analysis& analysis) {
  return static_cast<double>(analysis.lines().samples) / analysis.record().fs_Hz;
}

TEST(RecordSource, UsesAllSamplesOfShortRecordsOfOneHit) {
  for (const double hum_mps2 : {0.0, 30.0}) {
    const Analysis analysis = analysis_of(with_hum(of_single_rows(two_modes(2, 4)), hum_mps2));
    EXPECT_GT(used_s(analysis), 1.95) << hum_mps2;
    EXPECT_FALSE(analysis.decay_cut());
  }
}

TEST(RecordSource, CutsSeveralHitsOfARowAtTheEndOfTheirDecay) {
  const Analysis analysis = analysis_of(synth::synthesise(several_in_a_row(24, 4)).record);
  ASSERT_TRUE(analysis.decay_cut());
  EXPECT_LT(used_s(analysis), 2);
  EXPECT_EQ(analysis.decay_cut()->used_s, used_s(analysis));
  EXPECT_GT(analysis.decay_cut()->all_s, 3);
}

// Hum is as loud as the first mode some 0.1 s after the hit. Its level must not be taken for the end of the decay.
TEST(RecordSource, KeepsADecayThatHumHides) {
  const acquire::Record quiet = synth::synthesise(several_in_a_row(24, 4)).record;
  const Analysis analysis = analysis_of(with_hum(quiet, 10));
  const double decay_per_s = kTwoPi * kFreq_Hz * kDamping;
  constexpr double kDecayed = 0.01;
  EXPECT_LT(std::exp(-decay_per_s * used_s(analysis)), kDecayed);
  const auto& modes = analysis.modes();
  EXPECT_THAT(test::codes_of(analysis.warnings()), Contains("hum"));
  EXPECT_THAT(test::codes_of(analysis.warnings()), Not(Contains("tone")));
  test::expect_modes_near(modes, {{kFreq_Hz, kDamping}, {1900, 0.01}});
}

// The phases of two hits do not tell hum from a mode, and the pre-trigger of 128 samples is less than a period. The
// samples before it show the hum.
TEST(RecordSource, FindsHumInTheSamplesBeforeTheHits) {
  synth::SynthSpec spec = two_modes(2, 2);
  spec.pretrigger_s = 0.2;
  const Analysis analysis = analysis_of(with_hum(of_single_rows(spec), 10));
  const auto& modes = analysis.modes();
  EXPECT_THAT(test::codes_of(analysis.warnings()), Contains("hum"));
  test::expect_modes_near(modes, {{kFreq_Hz, kDamping}, {1900, 0.01}});
}

TEST(RecordSource, UsesAStatedLength) {
  const Analysis analysis(synth::synthesise(several_in_a_row(24, 4)).record,
                          {.band_Hz = std::pair{kLow_Hz, kHigh_Hz}, .hits = {.length_s = 3.0}, .threads = 1});
  EXPECT_GT(used_s(analysis), 2.95);
  EXPECT_FALSE(analysis.decay_cut());
}

}  // namespace percuss::pipeline::record_source_test
