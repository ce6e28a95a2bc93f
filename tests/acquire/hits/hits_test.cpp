#include "acquire/hits/hits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/force_row.hpp"
#include "support/input_error.hpp"

namespace percuss::acquire::hits_test {

using Rows = std::vector<std::vector<double>>;

constexpr double kFs_Hz = 25600;
constexpr std::size_t kWidth = 8;
constexpr std::size_t kPretrigger = 128;

std::vector<double> with_pulses(std::size_t samples, const std::vector<double>& onsets, double peak_N = 200) {
  std::vector<double> x(samples);
  for (const double onset : onsets) test::add_haversine(x, onset, kWidth, peak_N);
  return x;
}

std::vector<Hit> hits_in(const Rows& rows, const HitOptions& options = {}) {
  return find_hits(test::force_record(kFs_Hz, rows), options);
}

TEST(FindHits, MeasuresThePulse) {
  const auto hits = hits_in({with_pulses(60000, {20000})});
  ASSERT_EQ(hits.size(), 1U);
  EXPECT_DOUBLE_EQ(hits[0].peak_N, 200);
  EXPECT_EQ(hits[0].peak, 20004U);
  // 5 % of the peak, interpolated between the haversine's samples 0 and 1.
  const double foot = 0.05 / std::pow(std::sin(std::numbers::pi / kWidth), 2);
  constexpr double kRounding = 1e-9;  // samples, of 20000
  EXPECT_LE(std::abs(hits[0].onset_s * kFs_Hz - (20000 + foot)), kRounding);
  EXPECT_LE(std::abs(hits[0].pulse_s * kFs_Hz - (kWidth - 2 * foot)), kRounding);
  EXPECT_TRUE(hits[0].findings.empty());
}

TEST(FindHits, CutsALongRecordFromEachPretriggerToTheNext) {
  const auto hits = hits_in({with_pulses(200000, {20000, 70000, 150000})});
  ASSERT_EQ(hits.size(), 3U);
  EXPECT_EQ(hits[0].first, 20004 - kPretrigger);
  EXPECT_EQ(hits[0].first + hits[0].samples, hits[1].first);
  EXPECT_EQ(hits[1].first, 70004 - kPretrigger);
  EXPECT_EQ(hits[1].first + hits[1].samples, hits[2].first);
  EXPECT_EQ(hits[2].first + hits[2].samples, 200000U);
  for (const Hit& hit : hits) EXPECT_FALSE(rejects(hit.findings));
}

// The samples of a hit begin before a slow pulse, too: twice the rise time before the peak. The rise from 5 % of the
// peak is 85.6 % of half a haversine.
TEST(FindHits, BeginsALongPulseAtRest) {
  std::vector<double> x(100'000);
  test::add_haversine(x, 20'000, 512, 200);  // 20 ms
  test::add_haversine(x, 60'000, 512, 200);
  const auto hits = hits_in({x});
  ASSERT_EQ(hits.size(), 2U);
  const double rise = 0.856 * 256;
  EXPECT_NEAR(static_cast<double>(hits[0].first), 20'256 - 2 * rise, 2);  // whole samples
  EXPECT_EQ(hits[0].first + hits[0].samples, hits[1].first);
  for (const Hit& hit : hits) EXPECT_TRUE(hit.findings.empty());
  const auto stated = hits_in({x}, {.pretrigger_s = 0.02});
  EXPECT_EQ(stated[0].first, 20'256U - 512U);
}

// An AC-coupled force channel swings back after a long pulse, by 5 % of its peak. A response that is read as the force
// rings.
TEST(FindHits, TellsAnUndershootFromARingingForce) {
  std::vector<double> coupled(60'000), ringing(60'000);
  test::add_haversine(coupled, 20'000, 256, 200);
  ringing = coupled;
  for (std::size_t i = 20'256; i < coupled.size(); ++i) {
    const double t_s = static_cast<double>(i - 20'256) / kFs_Hz;
    coupled[i] -= 0.05 * 200 * std::exp(-t_s / 0.1);
    ringing[i] += 0.3 * 200 * std::sin(2 * std::numbers::pi * 300 * t_s) * std::exp(-t_s / 0.1);
  }
  EXPECT_FALSE(rejects(hits_in({coupled})[0].findings));
  EXPECT_TRUE(has_finding(hits_in({ringing})[0].findings, FindingCode::no_pulse));
}

TEST(FindHits, TakesEachRowAsOneHitUnlessTheRecordIsContinuous) {
  Rows rows = {with_pulses(50000, {300, 30000}), with_pulses(40000, {500})};
  const auto one_each = hits_in(rows);
  ASSERT_EQ(one_each.size(), 2U);
  for (std::size_t row = 0; row < 2; ++row) {
    EXPECT_EQ(one_each[row].row, row);
    EXPECT_EQ(one_each[row].first, 0U);
    EXPECT_EQ(one_each[row].samples, rows[row].size());
  }
  Record record = test::force_record(kFs_Hz, rows);
  record.continuous = true;
  const auto searched = find_hits(record);
  ASSERT_EQ(searched.size(), 3U);
  EXPECT_EQ(searched[1].row, 0U);
  EXPECT_EQ(searched[1].peak, 30004U);
  EXPECT_EQ(searched[2].row, 1U);
}

TEST(FindHits, UsesTheGivenPretriggerAndLength) {
  const Rows row = {with_pulses(200000, {20000, 70000})};
  const auto hits = hits_in(row, {.pretrigger_s = 0.02, .length_s = 1.5});
  ASSERT_EQ(hits.size(), 2U);
  EXPECT_EQ(hits[0].first, 20004U - 512);
  EXPECT_EQ(hits[0].samples, 38400U);
  EXPECT_EQ(hits_in(row, {.length_s = 100})[0].samples, 50000U);  // the samples of the next hit begin there
  const auto none = hits_in(row, {.pretrigger_s = 0});
  EXPECT_EQ(none[0].first, 20004U);
  const auto early = hits_in({with_pulses(9000, {50})}, {.pretrigger_s = 1});
  EXPECT_EQ(early[0].first, 0U);
}

TEST(FindHits, KeepsThePulseForAnyLength) {
  for (const double length_s : {1e-4, 0.001, 0.1}) {
    for (const Rows& rows : {Rows(1, with_pulses(9000, {5000})), Rows(2, with_pulses(9000, {5000}))}) {
      for (const Hit& hit : hits_in(rows, {.length_s = length_s})) {
        EXPECT_GT(hit.first + hit.samples, hit.peak);
        EXPECT_LE(hit.first + hit.samples, 9000U);
      }
    }
  }
}

TEST(FindHits, SearchesOnlyTheSelectedTime) {
  const Rows row = {with_pulses(200000, {20000, 70000, 150000})};
  const auto middle = hits_in(row, {.from_s = 50000 / kFs_Hz, .to_s = 100000 / kFs_Hz});
  ASSERT_EQ(middle.size(), 1U);
  EXPECT_EQ(middle[0].peak, 70004U);
  EXPECT_EQ(middle[0].first + middle[0].samples, 100000U);
  EXPECT_EQ(hits_in(row, {.from_s = 50000 / kFs_Hz}).size(), 2U);
  const auto nothing = hits_in(row, {.to_s = 0.5});
  ASSERT_EQ(nothing.size(), 1U);
  EXPECT_TRUE(has_finding(nothing[0].findings, FindingCode::no_pulse));
}

TEST(FindHits, RejectsAnEmptyTimeRange) {
  const Rows row = {with_pulses(25600, {20000})};
  using testing::HasSubstr;
  EXPECT_THAT(test::input_error_of([&] { hits_in(row, {.from_s = 1}); }), HasSubstr("1 s long"));
  EXPECT_THAT(test::input_error_of([&] { hits_in(row, {.from_s = 0.5, .to_s = 0.5}); }),
              HasSubstr("between 0.5 s and 0.5 s"));
  EXPECT_THAT(test::input_error_of([&] { hits_in(row, {.to_s = -1}); }), HasSubstr("and -1 s"));
  EXPECT_EQ(hits_in(row, {.from_s = -5, .to_s = 99}).size(), 1U);
}

TEST(FindHits, UsesTheGivenTrigger) {
  auto x = with_pulses(100000, {20000});
  test::add_haversine(x, 60000, kWidth, 20);
  EXPECT_EQ(hits_in({x}).size(), 2U);
  EXPECT_EQ(hits_in({x}, {.trigger_N = 50}).size(), 1U);
  EXPECT_TRUE(has_finding(hits_in({x}, {.trigger_N = 500})[0].findings, FindingCode::no_pulse));
  EXPECT_TRUE(has_finding(hits_in({x, x}, {.trigger_N = 500})[1].findings, FindingCode::no_pulse));
}

TEST(FindHits, GatesTheForceToItsPulse) {
  std::vector<double> x(20000, 3.5);
  test::add_filtered_haversine(x, 5000.4, kWidth, 200);
  const Hit hit = hits_in({x})[0];
  EXPECT_TRUE(hit.ungated_N.empty());
  EXPECT_LE(hit.gated_N.size(), 144 + kWidth + 2);  // up to 72 samples of ringing on each side
  constexpr double kFloor = 1e-9 * 200 + 1e-13;     // of the peak; rounding of the offset
  double outside = 0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    const std::size_t at = n - hit.gate_first;
    const bool inside = n >= hit.gate_first && at < hit.gated_N.size();
    if (inside) {
      ASSERT_EQ(hit.gated_N[at], x[n] - 3.5);
    } else {
      outside = std::max(outside, std::abs(x[n] - 3.5));
    }
  }
  EXPECT_LE(outside, kFloor);
}

TEST(FindHits, KeepsTheWholeForceWhenNotGated) {
  auto x = with_pulses(60000, {5000, 40000});
  for (double& value : x) value += 8;
  for (const Rows& rows : {Rows(1, x), Rows(2, x)}) {
    for (const Hit& hit : hits_in(rows, {.gate_force = false})) {
      ASSERT_EQ(hit.ungated_N.size(), hit.samples);
      for (std::size_t i = 0; i < hit.samples; ++i) ASSERT_EQ(hit.ungated_N[i], x[hit.first + i] - 8);
    }
  }
}

TEST(FindHits, DoesNotDependOnUnitOffsetOrTheOrderOfRows) {
  Rows rows;
  for (const double onset : {400.0, 700.3, 900.7}) {
    rows.push_back(with_pulses(9000, {onset}, 50 + onset / 10));
    test::add_noise(rows.back(), 0.02, static_cast<std::uint64_t>(onset));
  }
  const auto plain = hits_in(rows);
  const auto turned = hits_in({rows[2], rows[0], rows[1]});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(turned[(i + 1) % 3].onset_s, plain[i].onset_s);
  for (const double scale : {0x1p-100, 0x1p100}) {  // 1e-30 … 1e30
    auto scaled = rows;
    for (auto& row : scaled) {
      for (double& value : row) value *= scale;
    }
    const auto hits = hits_in(scaled);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(hits[i].peak_N, plain[i].peak_N * scale);
      EXPECT_EQ(hits[i].onset_s, plain[i].onset_s);
      EXPECT_EQ(hits[i].bandwidth_Hz, plain[i].bandwidth_Hz);
      EXPECT_EQ(hits[i].gated_N.size(), plain[i].gated_N.size());
      EXPECT_TRUE(hits[i].findings.empty());
    }
  }
}

TEST(FindHits, SurvivesRowsOfAFewSamples) {
  for (const std::size_t samples : {1U, 2U, 3U, 4U, 9U}) {
    for (std::size_t at = 0; at <= samples; ++at) {  // one past the end: silence
      for (const double level : {0.0, 5.0}) {
        std::vector<double> x(samples, level);
        if (at < samples) x[at] += 100;
        for (const bool gate : {true, false}) {
          const auto alone = hits_in({x}, {.gate_force = gate});
          const auto beside = hits_in({x, with_pulses(9000, {400})}, {.gate_force = gate});
          ASSERT_EQ(alone.size(), 1U);
          ASSERT_EQ(beside.size(), 2U);
          const bool silent = at == samples || samples < 3;
          EXPECT_EQ(has_finding(alone[0].findings, FindingCode::no_pulse), silent) << samples << ' ' << at;
          EXPECT_EQ(has_finding(beside[0].findings, FindingCode::no_pulse), silent) << samples << ' ' << at;
        }
      }
    }
  }
}

}  // namespace percuss::acquire::hits_test
