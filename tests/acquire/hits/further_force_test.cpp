#include "acquire/hits/further_force.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "acquire/hits/hits.hpp"
#include "support/force_row.hpp"

namespace percuss::acquire::further_force_test {

constexpr double kFs_Hz = 25600, kNoise_N = 0.05, kPeak_N = 300;
constexpr std::size_t kSamples = 12000;
constexpr double kOnset = 500.4, kWidth = 8;

std::vector<double> pulse_row() {
  std::vector<double> x(kSamples);
  test::add_filtered_haversine(x, kOnset, kWidth, kPeak_N);
  test::add_noise(x, kNoise_N, 7);
  return x;
}

/// The ringing of a hammer after its pulse: a decaying oscillation.
void add_ringing(std::vector<double>& x, double period, double time_constant, double size_N) {
  const auto first = static_cast<std::size_t>(kOnset + kWidth);
  for (std::size_t n = first; n < x.size(); ++n) {
    const double t = static_cast<double>(n - first);
    x[n] += size_N * std::exp(-t / time_constant) * std::sin(2 * std::numbers::pi * t / period);
  }
}

Hit hit_of(const std::vector<double>& row) { return find_hits(test::force_record(kFs_Hz, {row, row})).front(); }

/// Whether the gate holds the force of this sample.
bool holds(const Hit& hit, const std::vector<double>& row, std::size_t sample) {
  return sample >= hit.gate_first && sample < hit.gate_first + hit.gated_N.size() &&
         std::abs(hit.gated_N[sample - hit.gate_first] - (row[sample] - hit.baseline_N)) < 1e-9;
}

TEST(FurtherForce, DoesNotTakeRingingOfTheHammerForASecondHitAndKeepsIt) {
  for (const double period : {3.7, 6.4, 17.0, 30.0}) {
    for (const double size : {0.02, 0.08, 0.5}) {
      auto row = pulse_row();
      add_ringing(row, period, 150, size * kPeak_N);
      const Hit hit = hit_of(row);
      EXPECT_TRUE(hit.findings.empty()) << period << ' ' << size << ' ' << hit.findings.front().message;
      for (std::size_t n = 510; n < 650; ++n) EXPECT_TRUE(holds(hit, row, n)) << period << ' ' << size << ' ' << n;
    }
  }
}

TEST(FurtherForce, TakesATailForAPartOfTheContact) {
  for (const auto& [size, width] : {std::pair{0.005, 100.0}, {0.02, 200.0}, {0.05, 400.0}, {0.08, 60.0}}) {
    auto row = pulse_row();
    test::add_haversine(row, kOnset + 4, width, size * kPeak_N);
    const Hit hit = hit_of(row);
    EXPECT_TRUE(hit.findings.empty()) << size << ' ' << hit.findings.front().message;
    const auto end = static_cast<std::size_t>(kOnset + 4 + 0.8 * width);
    for (std::size_t n = 510; n < end; ++n) EXPECT_TRUE(holds(hit, row, n)) << size << ' ' << n;
  }
}

TEST(FurtherForce, KeepsASecondContactOfAnySize) {
  for (const double ratio : {0.003, 0.02, 0.3}) {
    auto row = pulse_row();
    test::add_filtered_haversine(row, kOnset + 460, kWidth, ratio * kPeak_N);
    const Hit hit = hit_of(row);
    ASSERT_EQ(hit.findings.size(), 1U) << ratio;
    EXPECT_EQ(hit.findings[0].code, FindingCode::double_hit);
    EXPECT_EQ(rejects(hit.findings), ratio > 0.05);
    for (std::size_t n = 960; n < 970; ++n) EXPECT_TRUE(holds(hit, row, n)) << ratio << ' ' << n;
    EXPECT_EQ(hit.gated_N[700 - hit.gate_first], 0) << ratio;  // only noise
  }
}

TEST(FurtherForce, LeavesASpikeOut) {
  auto row = pulse_row();
  row[900] += 0.5 * kPeak_N;
  const Hit hit = hit_of(row);
  ASSERT_EQ(hit.findings.size(), 1U);
  EXPECT_NE(hit.findings[0].message.find("spike"), std::string::npos);
  EXPECT_LT(hit.gate_first + hit.gated_N.size(), 900U);
}

TEST(FurtherForce, IsNoHumpDriftOrHum) {
  const std::vector<double> plain = pulse_row();
  auto hump = plain, drift = plain, hum = plain;
  test::add_haversine(hump, 3000, 1500, 0.02 * kPeak_N);
  for (std::size_t n = 0; n < kSamples; ++n) {
    drift[n] += 1e-4 * static_cast<double>(n);
    hum[n] += 0.02 * kPeak_N * std::sin(0.0123 * static_cast<double>(n));
  }
  for (const auto& row : {hump, drift, hum}) {
    const Hit hit = hit_of(row);
    EXPECT_TRUE(hit.findings.empty()) << hit.findings.front().message;
    EXPECT_LT(hit.gate_first + hit.gated_N.size(), 700U);
  }
}

// A recorder of 12 bits rounds slow noise up by a whole step, 0.16 % of the peak.
TEST(FurtherForce, IsNoSingleStepOfTheRecorder) {
  constexpr double kStep_N = 2000.0 / 4096;
  const auto rounded = [&](std::vector<double> row) {
    for (double& x : row) x = kStep_N * std::round(x / kStep_N);
    return row;
  };
  std::vector<double> row(kSamples);
  test::add_filtered_haversine(row, kOnset, kWidth, kPeak_N);
  std::vector<double> stepped = rounded(row), twice = row;
  for (std::size_t n = 3000; n < 3008; ++n) stepped[n] += kStep_N;
  EXPECT_TRUE(hit_of(stepped).findings.empty());
  test::add_filtered_haversine(twice, 3000, kWidth, 5 * kStep_N);
  EXPECT_FALSE(hit_of(rounded(twice)).findings.empty()) << "five steps are a contact";
}

TEST(FurtherForce, RefusesAResponseInThePlaceOfTheForce) {
  std::vector<double> row = pulse_row();
  add_ringing(row, 37.3, 4000, 0.2 * kPeak_N);
  const Hit hit = hit_of(row);
  ASSERT_TRUE(rejects(hit.findings));
  EXPECT_EQ(hit.findings.back().code, FindingCode::no_pulse);
}

TEST(FurtherForce, LetsTheHitContinueAfterAHump) {
  std::vector<double> row(120000);
  for (const double onset : {5000.0, 60000.0}) test::add_filtered_haversine(row, onset, kWidth, kPeak_N);
  test::add_haversine(row, 20000, 4000, 0.02 * kPeak_N);
  test::add_noise(row, kNoise_N, 3);
  const std::vector<Hit> hits = find_hits(test::force_record(kFs_Hz, {row}));
  ASSERT_EQ(hits.size(), 2U);
  EXPECT_GT(hits[0].samples, 50000U);
}

}  // namespace percuss::acquire::further_force_test
