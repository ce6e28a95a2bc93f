#include "acquire/hits/trigger_scan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/parallel/parallel.hpp"
#include "support/force_row.hpp"

namespace percuss::acquire::trigger_scan_test {

using Events = std::vector<std::size_t>;

constexpr double kFs_Hz = 25600;
constexpr std::size_t kChunk = std::size_t{1} << 18U;  // about the samples per chunk of the scan
constexpr std::size_t kSeparation = 6400;              // 0.25 s

// A pulse of ±4 samples whose largest sample is `at`.
void add_pulse(std::vector<double>& x, std::size_t at, double peak) {
  test::add_haversine(x, static_cast<double>(at) - 4, 8, peak);
}

TriggerScan scan(const std::vector<double>& x, const TriggerOptions& options = {}) {
  return scan_for_triggers(test::force_record(kFs_Hz, {x}), 0, options);
}

TEST(TriggerScan, FindsPulsesOfEitherSignAtTheirLargestSample) {
  std::vector<double> x(100000);
  add_pulse(x, 5000, 200);
  add_pulse(x, 30000, -120);
  add_pulse(x, 70001, 3);
  const TriggerScan found = scan(x);
  EXPECT_EQ(found.events, (Events{5000, 30000, 70001}));
  EXPECT_EQ(found.baseline_N, 0);
  EXPECT_EQ(found.noise_N, 0);  // an exactly silent channel is valid
  EXPECT_DOUBLE_EQ(found.largest_N, 200);
  EXPECT_DOUBLE_EQ(found.trigger_N, 2);  // 1 % of the largest
}

TEST(TriggerScan, MeasuresBaselineAndNoiseBesideThePulses) {
  std::vector<double> x(60000, -7.5);
  test::add_noise(x, 0.4, 3);
  for (std::size_t at = 8000; at < 60000; at += 8000) add_pulse(x, at, 90);
  const TriggerScan found = scan(x);
  // 2.5 standard errors of an estimate from n = 1024 samples. The standard error of the median is 1.25 σ/√n, and the
  // standard error of the robust standard deviation is 1.17 σ/√n.
  constexpr double kTolerance = 2.5 * 1.3 * 0.4 / 32;
  EXPECT_LE(std::abs(found.baseline_N + 7.5), kTolerance);
  EXPECT_LE(std::abs(found.noise_N - 0.4), kTolerance);
  EXPECT_DOUBLE_EQ(found.trigger_N, 12 * found.noise_N);
  EXPECT_EQ(found.events.size(), 7U);
}

// The scan looks at blocks of samples. A pulse that lies in two of them is one event, whatever the sampling rate.
TEST(TriggerScan, FindsOnePulseWhereverItLies) {
  for (const double fs_Hz : {25.0, 50.0, 200.0, 1000.0, 6400.0}) {
    for (std::size_t at = 1000; at < 1000 + 130; ++at) {
      std::vector<double> x(4000);
      add_pulse(x, at, 100);
      x[at - 1] = 99;
      const TriggerScan found = scan_for_triggers(test::force_record(fs_Hz, {x}), 0);
      ASSERT_EQ(found.events, (Events{at})) << fs_Hz << " Hz, sample " << at;
    }
  }
}

TEST(TriggerScan, KeepsHitsApartAtLowRates) {
  for (const double fs_Hz : {50.0, 200.0, 1000.0}) {
    std::vector<double> x(4000);
    const auto apart = static_cast<std::size_t>(0.8 * fs_Hz);
    add_pulse(x, 1001, 100);
    add_pulse(x, 1001 + apart, 80);
    EXPECT_EQ(scan_for_triggers(test::force_record(fs_Hz, {x}), 0).events, (Events{1001, 1001 + apart})) << fs_Hz;
  }
}

TEST(TriggerScan, FindsNothingInNoiseAConstantOrSilence) {
  std::vector<double> noise(500000, 3.0);
  test::add_noise(noise, 1, 1);
  EXPECT_TRUE(scan(noise).events.empty());
  for (const double level : {0.0, -12.25}) {
    const TriggerScan found = scan(std::vector<double>(5000, level));
    EXPECT_TRUE(found.events.empty());
    EXPECT_EQ(found.largest_N, 0);
    EXPECT_EQ(found.baseline_N, level);
  }
  EXPECT_TRUE(scan({}).events.empty());
}

TEST(TriggerScan, JoinsPulsesWithinTheSeparation) {
  for (const double bounce : {30.0, 170.0}) {  // smaller or larger than the first
    std::vector<double> x(50000);
    add_pulse(x, 10000, 100);
    add_pulse(x, 10000 + kSeparation / 3, bounce);
    add_pulse(x, 30000, 80);
    EXPECT_EQ(scan(x).events, (Events{bounce < 100 ? 10000 : 10000 + kSeparation / 3, 30000}));
  }
}

TEST(TriggerScan, SeparatesPulsesFurtherApart) {
  std::vector<double> x(50000);
  add_pulse(x, 10000, 100);
  add_pulse(x, 10000 + kSeparation + 256, 45);
  EXPECT_EQ(scan(x).events, (Events{10000, 10000 + kSeparation + 256}));
  EXPECT_EQ(scan(x, {.separation_s = 0.5}).events, (Events{10000}));
  EXPECT_EQ(scan(x, {.separation_s = 0}).events.size(), 2U);
}

TEST(TriggerScan, SeparatesHitsInQuickSuccession) {
  const std::size_t apart = kSeparation * 3 / 5;
  for (const double second : {60.0, 100.0, 160.0}) {
    std::vector<double> x(50000);
    for (std::size_t hit = 0; hit < 5; ++hit) add_pulse(x, 10000 + hit * apart, hit % 2 == 0 ? 100 : second);
    EXPECT_EQ(scan(x).events, (Events{10000, 10000 + apart, 10000 + 2 * apart, 10000 + 3 * apart, 10000 + 4 * apart}))
        << second;
  }
}

TEST(TriggerScan, JoinsAWeakerPulseThatFollowsLate) {
  std::vector<double> x(50000);
  add_pulse(x, 10000, 100);
  add_pulse(x, 10000 + kSeparation * 3 / 5, 40);
  EXPECT_EQ(scan(x).events, Events{10000});
}

TEST(TriggerScan, TakesAForceThatRingsAtTheTriggerAsOneEvent) {
  std::vector<double> x(60000);
  for (std::size_t n = 20000; n < x.size(); ++n) {
    const double t = static_cast<double>(n - 20000) / kFs_Hz;
    x[n] = 100 * std::exp(-t / 0.02) * std::cos(1000 * t);
  }
  EXPECT_EQ(scan(x, {.trigger_N = 5}).events, Events{20000});
}

TEST(TriggerScan, UsesTheGivenTrigger) {
  std::vector<double> x(60000);
  add_pulse(x, 10000, 100);
  add_pulse(x, 30000, 10);
  EXPECT_EQ(scan(x, {.trigger_N = 20}).events, Events{10000});
  EXPECT_EQ(scan(x, {.trigger_N = 10}).events, (Events{10000, 30000}));
  EXPECT_TRUE(scan(x, {.trigger_N = 101}).events.empty());
}

// The first sample of each read, in the scan of a silent row of this length.
std::vector<std::size_t> part_borders(std::size_t samples) {
  Record record = test::force_record(kFs_Hz, {std::vector<double>(samples)});
  std::vector<std::size_t> starts;
  record.read_force_N = [&](std::size_t, std::size_t first, std::span<double> out) {
    starts.push_back(first);
    std::fill(out.begin(), out.end(), 0.0);
  };
  const ThreadLimit one(1);  // in order
  scan_for_triggers(record, 0);
  return starts;
}

TEST(TriggerScan, FindsPulsesAtTheBordersOfChunksAndBlocks) {
  constexpr std::size_t kSamples = 2 * kChunk + 1000;
  const std::vector<std::size_t> parts = part_borders(kSamples);
  ASSERT_EQ(parts.size() % 3, 0U);  // three chunks with equally many reads; a block begins at 32000
  std::vector<std::size_t> borders{32000, parts[parts.size() / 3], parts[2 * parts.size() / 3], parts.back()};
  std::vector<double> all(kSamples);
  for (const std::size_t border : borders) {
    for (const std::size_t at : {border - 1, border}) {
      std::vector<double> one(kSamples);
      add_pulse(one, at, 50);
      EXPECT_EQ(scan(one).events, Events{at});
    }
    add_pulse(all, border, 50);
  }
  EXPECT_EQ(scan(all).events, borders);
}

TEST(TriggerScan, FindsAPulseAtTheVeryFirstAndLastSample) {
  for (const std::size_t size : {3U, 64U, 65U, 1000U}) {
    for (const std::size_t at : {std::size_t{0}, size - 1}) {
      std::vector<double> x(size);
      x[at] = -4;
      EXPECT_EQ(scan(x).events, Events{at}) << size;
    }
  }
}

TEST(TriggerScan, MeasuresBaselineAndNoiseForAnyLengthOfTheLastChunk) {
  for (const std::size_t extra : {0U, 1U, 2U, 70U, 5000U}) {
    std::vector<double> x(kChunk + extra, 20.0);
    test::add_noise(x, 0.5, extra);
    x.back() = 300;
    const TriggerScan found = scan(x);
    constexpr double kTolerance = 2.5 * 1.3 * 0.5 / 32;  // as above
    EXPECT_LE(std::abs(found.baseline_N - 20), kTolerance) << extra;
    EXPECT_LE(std::abs(found.noise_N - 0.5), kTolerance) << extra;
  }
}

TEST(TriggerScan, SearchesOnlyTheSelectedSamples) {
  std::vector<double> x(60000);
  for (const std::size_t at : {10000U, 30000U, 50000U}) add_pulse(x, at, 100);
  EXPECT_EQ(scan(x, {.first = 20001}).events, (Events{30000, 50000}));
  EXPECT_EQ(scan(x, {.last = 30001}).events, (Events{10000, 30000}));
  EXPECT_EQ(scan(x, {.first = 29990, .last = 30010}).events, Events{30000});
  EXPECT_TRUE(scan(x, {.first = 12000, .last = 20000}).events.empty());
  EXPECT_TRUE(scan(x, {.first = 60000}).events.empty());
  EXPECT_TRUE(scan(x, {.first = 5, .last = 5}).events.empty());
}

TEST(TriggerScan, ReadsEachSampleOnceAndTheBlocksOfItsEventsTwice) {
  std::vector<double> x(2 * kChunk + 777);
  for (const std::size_t at : {1000U, 100000U, 300000U}) add_pulse(x, at, 100);
  Record record = test::force_record(kFs_Hz, {x});
  const auto reads = std::make_shared<std::vector<int>>(x.size());
  record.read_force_N = [reads, inner = record.read_force_N](std::size_t row, std::size_t first,
                                                             std::span<double> out) {
    for (std::size_t i = 0; i < out.size(); ++i) ++reads->at(first + i);
    inner(row, first, out);
  };
  record.read_accel_mps2 = [](std::size_t, std::size_t, std::size_t, std::span<double>) { FAIL() << "not asked for"; };
  const TriggerScan found = scan_for_triggers(record, 0, {.first = 500});
  ASSERT_EQ(found.events.size(), 3U);
  const auto times = [&](int n) { return static_cast<std::size_t>(std::count(reads->begin(), reads->end(), n)); };
  EXPECT_EQ(times(0), 500U);
  EXPECT_EQ(times(2), 192U);  // three blocks of 64
  EXPECT_EQ(times(1), x.size() - 500 - 192);
}

TEST(TriggerScan, DoesNotDependOnUnitSignOrOffset) {
  std::vector<double> x(100000);
  test::add_noise(x, 0.25, 7);
  for (const std::size_t at : {9000U, 40000U, 77777U}) add_pulse(x, at, 60);
  const TriggerScan plain = scan(x);
  for (const double scale : {-1.0, 0x1p-100, -0x1p100}) {  // 1e-30 … 1e30
    auto scaled = x;
    for (double& value : scaled) value *= scale;
    const TriggerScan found = scan(scaled);
    EXPECT_EQ(found.events, plain.events);
    EXPECT_EQ(found.noise_N, plain.noise_N * std::abs(scale));
    EXPECT_EQ(found.trigger_N, plain.trigger_N * std::abs(scale));
  }
  for (double& value : x) value += 5000;
  EXPECT_EQ(scan(x).events, plain.events);
}

}  // namespace percuss::acquire::trigger_scan_test
