#include "pipeline/live/online_trigger.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "acquire/hits/hits.hpp"
#include "support/live/live_source.hpp"
#include "synth/read_spec.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::online_trigger_test {

std::vector<double> force_of(const acquire::Record& record) {
  std::vector<double> x(record.rows[0].samples);
  record.read_force_N(0, 0, x);
  return x;
}

std::vector<std::uint64_t> peaks(const std::vector<double>& force, double fs_Hz, std::size_t block,
                                 std::optional<double> trigger_N = {}) {
  OnlineTrigger trigger({.fs_Hz = fs_Hz, .trigger_N = trigger_N}, 1000);
  std::vector<std::uint64_t> out;
  const auto take = [&] {
    while (const auto event = trigger.next()) out.push_back(event->peak - 1000);
  };
  for (std::size_t at = 0; at < force.size(); at += block) {
    trigger.add(std::span(force).subspan(at, std::min(block, force.size() - at)));
    take();
  }
  trigger.finish();
  take();
  return out;
}

std::vector<std::uint64_t> peaks_found_afterwards(const acquire::Record& record) {
  std::vector<std::uint64_t> out;
  for (const acquire::Hit& hit : acquire::find_hits(record)) out.push_back(hit.peak);
  return out;
}

TEST(OnlineTrigger, FindsTheHitsThatFindHitsFindsAfterwards) {
  // Six hits in 30 s, one double, one of 6 % of the usual force.
  const acquire::Record bat = synth::synthesise(synth::synth_preset("long-continuous")).record;
  // Separate blows in quick succession; the first in the first 10 ms, the last cut by the end.
  const acquire::Record quick = test::struck_tube("0.008, 0.9, 1.05, 2, 2.14, 2.29, 3.98", 4);
  for (const acquire::Record* record : {&bat, &quick}) {
    const auto expected = peaks_found_afterwards(*record);
    ASSERT_GE(expected.size(), 5U);
    EXPECT_EQ(peaks(force_of(*record), record->fs_Hz, 4096), expected);
  }
}

TEST(OnlineTrigger, DoesNotDependOnTheSizeOfTheBlocks) {
  const acquire::Record record = test::struck_tube("0.3, 1.1, 1.2, 2.5", 3.5);
  const std::vector<double> force = force_of(record);
  const auto whole = peaks(force, record.fs_Hz, force.size());
  EXPECT_EQ(whole.size(), 4U);
  for (const std::size_t block : {1U, 37U, 511U, 512U, 5000U}) EXPECT_EQ(peaks(force, record.fs_Hz, block), whole);
}

TEST(OnlineTrigger, IgnoresNoiseStepsOfTheConverterAndDrift) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> noise(400'000), steps(400'000), drift(400'000);
  for (std::size_t i = 0; i < noise.size(); ++i) {
    noise[i] = 3 + normal(random);
    steps[i] = i % 7 == 0 || i % 11 == 3 ? 0.01 : 0;
    drift[i] = 200 * std::sin(static_cast<double>(i) / 30'000) + 0.1 * normal(random);
  }
  for (const auto& silent : {noise, steps, drift}) EXPECT_TRUE(peaks(silent, 51200, 4096).empty());
}

TEST(OnlineTrigger, TakesTheStatedThreshold) {
  const acquire::Record record =
      test::struck_tube("0.5, 1.5, 2.5", 3.5, R"("faults": [{"hit": 1, "kind": "weak", "ratio": 0.3}])");
  const std::vector<double> force = force_of(record);
  EXPECT_EQ(peaks(force, record.fs_Hz, 512).size(), 3U);
  EXPECT_EQ(peaks(force, record.fs_Hz, 512, 150).size(), 2U);
}

// One blow far above the others must not raise the threshold above the blows that follow.
TEST(OnlineTrigger, FindsBlowsAfterAnAccident) {
  std::vector<double> force(200'000);
  std::mt19937 random(2);
  std::normal_distribution<double> normal(0, 0.01);
  for (double& value : force) value = normal(random);
  const auto strike = [&](std::size_t at, double peak_N) {
    for (std::size_t i = 0; i < 12; ++i)
      force[at + i] += peak_N * std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / 12);
  };
  for (std::size_t i = 0; i < 4; ++i) strike(10'000 + 40'000 * i, i == 1 ? 9000 : 20);
  EXPECT_EQ(peaks(force, 25600, 512).size(), 4U);
}

// Force at rest with one sin² push.
std::vector<double> one_push(double fs_Hz, double at_s, double length_s, double end_s) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0, 1e-4);
  std::vector<double> force(static_cast<std::size_t>(end_s * fs_Hz));
  for (std::size_t i = 0; i < force.size(); ++i) {
    const double phase = (static_cast<double>(i) / fs_Hz - at_s) / length_s;
    const double root = phase > 0 && phase < 1 ? std::sin(std::numbers::pi * phase) : 0;
    force[i] = normal(random) + 300 * root * root;
  }
  return force;
}

// The noise is learnt from samples that hold the blow.
TEST(OnlineTrigger, FindsABlowThatComesEarly) {
  for (const double fs_Hz : {100.0, 200.0, 256.0, 500.0, 640.0, 900.0, 4096.0, 51200.0}) {
    for (const double at_s : {0.02, 0.3, 0.5, 0.85, 1.0, 1.9})
      EXPECT_EQ(peaks(one_push(fs_Hz, at_s, 0.04, 5), fs_Hz, 4096).size(), 1U) << fs_Hz << " Hz, " << at_s << " s";
  }
}

// A hammer whose amplifier settles: its baseline moves by much more than the noise.
TEST(OnlineTrigger, FindsBlowsWhileTheForceDrifts) {
  for (const double drift_Nps : {-20.0, -3.0, 3.0, 20.0}) {
    for (const double fs_Hz : {1000.0, 12800.0, 51200.0}) {
      std::vector<double> force;
      for (int blow = 0; blow < 4; ++blow) {
        const std::vector<double> one = one_push(fs_Hz, 1.2, 0.004, 3);
        force.insert(force.end(), one.begin(), one.end());
      }
      for (std::size_t i = 0; i < force.size(); ++i) force[i] += drift_Nps * static_cast<double>(i) / fs_Hz;
      OnlineTrigger trigger({.fs_Hz = fs_Hz, .trigger_N = {}}, 0);
      trigger.add(force);
      trigger.finish();
      for (int blow = 0; blow < 4; ++blow) {
        const auto event = trigger.next();
        ASSERT_TRUE(event.has_value()) << drift_Nps << " N/s, " << fs_Hz << " Hz";
        EXPECT_NEAR(static_cast<double>(event->peak) / fs_Hz, 3 * blow + 1.202, 0.0015);
        EXPECT_FALSE(event->earlier && event->earlier->ratio > 0.05);
      }
      EXPECT_FALSE(trigger.next().has_value());
    }
  }
}

TEST(OnlineTrigger, ReportsEachPushThatIsTooLong) {
  for (const double length_s : {0.07, 0.12, 0.25}) {
    OnlineTrigger trigger({.fs_Hz = 1000, .trigger_N = {}}, 0);
    for (int push = 0; push < 3; ++push) trigger.add(one_push(1000, 1, length_s, 4));
    trigger.finish();
    EXPECT_FALSE(trigger.next().has_value());
    for (int i = 0; i < 3; ++i) {
      const auto push = trigger.next_long_push();
      ASSERT_TRUE(push.has_value()) << length_s;
      EXPECT_NEAR(push->peak_N, 300, 1);
      EXPECT_NEAR(push->length_s, 0.856 * length_s, 0.001);  // sin² exceeds 5 % on 85.6 % of its length
    }
    EXPECT_FALSE(trigger.next_long_push().has_value());
  }
}

TEST(OnlineTrigger, MeasuresTheRise) {
  OnlineTrigger trigger({.fs_Hz = 12800, .trigger_N = {}}, 0);
  trigger.add(one_push(12800, 1, 0.02, 4));
  trigger.finish();
  const auto event = trigger.next();
  ASSERT_TRUE(event.has_value());
  EXPECT_NEAR(static_cast<double>(event->rise), 0.856 * 128, 1);
}

TEST(OnlineTrigger, StatesTheLastFrameSearched) {
  OnlineTrigger trigger({.fs_Hz = 4096}, 0);
  std::vector<double> quiet(4096);
  for (std::size_t i = 0; i < quiet.size(); ++i) quiet[i] = i % 2 == 0 ? 0.001 : -0.001;
  trigger.add(quiet);
  EXPECT_EQ(trigger.searched_to(), 4096U);
  quiet[100] = 50;
  trigger.add(std::span(quiet).first(1024));  // too few: an event is decided 0.3 s after it begins
  EXPECT_EQ(trigger.searched_to(), 4196U);
  EXPECT_FALSE(trigger.next().has_value());
}

}  // namespace percuss::pipeline::online_trigger_test
