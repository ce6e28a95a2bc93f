#include "pipeline/run_analyses.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>
#include <variant>

#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::run_analyses_test {

synth::SynthSpec bat() {
  return test::bat_spec({{.freq_Hz = 180, .damping_ratio = 0.01, .order = 1, .amplitude_per_sqrt_kg = 1.7}}, 1);
}

TEST(SplitRuns, GivesEachRunItsRows) {
  synth::SynthSpec spec = bat();
  spec.runs = 3;
  const auto runs = split_runs(synth::synthesise(spec).record);
  ASSERT_EQ(runs.size(), 3U);
  for (const auto& [run, record] : runs) EXPECT_EQ(record.rows.size(), 3U) << run;
}

TEST(SplitRuns, ViewsTheSamplesOfASingleRun) {
  const acquire::Record record = synth::synthesise(bat()).record;
  const auto runs = split_runs(record);
  ASSERT_EQ(runs.size(), 1U);
  std::vector<double> buffer;
  const std::size_t samples = record.rows.front().samples;
  EXPECT_EQ(runs.front().second.read_force_N.view_or_read(0, 0, samples, buffer).data(),
            record.read_force_N.view_or_read(0, 0, samples, buffer).data());
}

acquire::Record two_runs() {
  synth::SynthSpec spec = bat();
  spec.runs = 2;
  return synth::synthesise(spec).record;
}

TEST(AnalysesOfRuns, NumberTheRunsOfOneRecordAsTheRecordDoes) {
  std::vector<acquire::Record> one;
  one.push_back(two_runs());
  for (acquire::RowInfo& row : one.front().rows) row.run += 3;
  const auto analyses = analyses_of_runs(std::move(one), {});
  ASSERT_EQ(analyses.size(), 2U);
  EXPECT_EQ(analyses[0].run, 3);
  EXPECT_EQ(analyses[1].run, 4);
}

TEST(AnalysesOfRuns, NumberTheRunsOfSeveralRecordsInOrder) {
  std::vector<acquire::Record> two;
  two.push_back(two_runs());
  two.push_back(two_runs());
  const auto analyses = analyses_of_runs(std::move(two), {});
  ASSERT_EQ(analyses.size(), 4U);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(analyses[static_cast<std::size_t>(i)].run, i);
}

TEST(AnalysesOfRuns, AssumeTheAnglesOfTwoAccelerometers) {
  constexpr double kRounding = 1e-15;  // of 90° in radians
  acquire::Record record = synth::synthesise(bat()).record;
  for (acquire::SignalInfo& signal : record.accel) signal.angle_rad.reset();
  const auto analyses = analyses_of_runs(std::variant<acquire::Record, acquire::FrfRecord>(std::move(record)), {});
  const acquire::Record& assumed = analyses.front().analysis->record();
  EXPECT_EQ(assumed.accel[0].angle_rad, 0);
  EXPECT_NEAR(*assumed.accel[1].angle_rad, std::numbers::pi / 2, kRounding);
  EXPECT_TRUE(assumed.notes.empty());  // the modes decide whether the angles hold: warning assumed_tube or not_a_tube
}

}  // namespace percuss::pipeline::run_analyses_test
