#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "acquire/hits/hits.hpp"
#include "support/force_row.hpp"
#include "synth/synthesise.hpp"

namespace percuss::acquire::hits_grade_test {

constexpr double kFs_Hz = 25600;
constexpr std::size_t kSamples = 12000;

std::vector<double> good_row(double onset = 500.3, double peak_N = 200) {
  std::vector<double> x(kSamples);
  test::add_filtered_haversine(x, onset, 8, peak_N);
  return x;
}

/// The hit of `row` among good ones.
Hit hit_of(const std::vector<double>& row, const HitOptions& options = {}) {
  return find_hits(test::force_record(kFs_Hz, {good_row(), row, good_row(450.8)}), options).at(1);
}

const Finding* found(const Hit& hit, FindingCode code) {
  const auto at =
      std::find_if(hit.findings.begin(), hit.findings.end(), [&](const Finding& f) { return f.code == code; });
  return at == hit.findings.end() ? nullptr : &*at;
}

/// The finding with this code if it is the only one, else nullptr.
const Finding* only(const Hit& hit, FindingCode code) { return hit.findings.size() == 1 ? found(hit, code) : nullptr; }

TEST(HitFindings, AreNoneForAGoodHit) {
  for (const double noise : {0.0, 1e-4, 0.5}) {
    auto row = good_row();
    test::add_noise(row, noise, 4);
    EXPECT_TRUE(hit_of(row).findings.empty()) << noise;
  }
}

TEST(HitFindings, ReportASecondHitAfterOrBeforeTheMainOne) {
  constexpr double kDelayTolerance_s = 1 / kFs_Hz;  // each of the two peaks is found to half a sample
  constexpr double kRatioTolerance = 0.06;          // relative: peaks half a sample off, in pulses of 8 samples
  for (const double delay : {31.5, 256.0, 2560.4, -31.5, -400.2}) {
    for (const double ratio : {0.06, 0.4}) {
      auto row = good_row();
      test::add_filtered_haversine(row, 500.3 + delay, 8, 200 * ratio);
      const Hit hit = hit_of(row);
      const Finding* finding = only(hit, FindingCode::double_hit);
      ASSERT_NE(finding, nullptr) << delay << ' ' << ratio;
      EXPECT_EQ(finding->severity, Severity::reject);
      EXPECT_LE(std::abs(finding->value / ratio - 1), kRatioTolerance) << delay << ' ' << ratio;
      ASSERT_TRUE(finding->delay_s);
      EXPECT_LE(std::abs(*finding->delay_s - std::abs(delay) / kFs_Hz), kDelayTolerance_s) << delay;
      EXPECT_EQ(finding->message.find("before") != std::string::npos, delay < 0) << finding->message;
    }
  }
}

TEST(HitFindings, RejectASecondHitOnlyAboveFivePercent) {
  auto row = good_row();
  test::add_filtered_haversine(row, 900.3, 8, 200 * 0.04);
  const Hit hit = hit_of(row);
  ASSERT_NE(only(hit, FindingCode::double_hit), nullptr);
  EXPECT_EQ(hit.findings[0].severity, Severity::info);
  EXPECT_FALSE(rejects(hit.findings));
}

TEST(HitFindings, ReportASecondHitOnBothSidesInALongRecord) {
  for (const double delay : {310.0, 900.0, -310.0, -2000.0}) {
    std::vector<double> x(120000);
    for (const double onset : {20000.0, 50000.0, 90000.0}) test::add_filtered_haversine(x, onset, 8, 200);
    test::add_filtered_haversine(x, 50000 + delay, 8, 60);
    const auto hits = find_hits(test::force_record(kFs_Hz, {x}));
    ASSERT_EQ(hits.size(), 3U) << delay;
    EXPECT_TRUE(hits[0].findings.empty());
    EXPECT_TRUE(hits[2].findings.empty());
    const Finding* finding = only(hits[1], FindingCode::double_hit);
    ASSERT_NE(finding, nullptr) << delay;
    EXPECT_LE(std::abs(*finding->delay_s * kFs_Hz - std::abs(delay)), 1) << delay;
  }
}

TEST(HitFindings, ReportALateTrigger) {
  const auto whole = good_row();
  for (const std::ptrdiff_t start : {502, 504}) {  // on the flank, at the peak
    const std::vector<double> row(whole.begin() + start, whole.end());
    const Hit hit = hit_of(row);
    const Finding* finding = only(hit, FindingCode::late_trigger);
    ASSERT_NE(finding, nullptr) << start;
    EXPECT_EQ(finding->severity, Severity::reject);
    EXPECT_LE(std::abs(finding->value - row[0] / hit.peak_N), 1e-6);  // the ringing in the baseline
  }
  EXPECT_TRUE(hit_of({whole.begin() + 400, whole.end()}).findings.empty());
}

TEST(HitFindings, ReportNoPulseInDriftNoiseOrSilence) {
  std::vector<double> drift(kSamples), noise(kSamples), hum(kSamples);
  for (std::size_t n = 0; n < kSamples; ++n) {
    drift[n] = 1e-3 * static_cast<double>(n);
    hum[n] = 2 * std::sin(0.0123 * static_cast<double>(n));
  }
  test::add_noise(noise, 0.3, 9);
  auto noisy_drift = drift;
  test::add_noise(noisy_drift, 0.01, 3);
  for (const auto& row :
       {drift, noise, hum, noisy_drift, std::vector<double>(kSamples), std::vector<double>(kSamples, -4.5)}) {
    for (const Hit& hit : {hit_of(row), find_hits(test::force_record(kFs_Hz, {row})).at(0)}) {
      ASSERT_NE(only(hit, FindingCode::no_pulse), nullptr);
      EXPECT_EQ(hit.findings[0].severity, Severity::reject);
      EXPECT_EQ(hit.peak_N, 0);
      EXPECT_TRUE(hit.gated_N.empty());
      EXPECT_TRUE(std::isfinite(hit.findings[0].value));
    }
  }
}

TEST(HitFindings, DoNotTakeASlowPushForAHit) {
  std::vector<double> row(kSamples);
  test::add_haversine(row, 2000, 0.1 * kFs_Hz, 50);  // 100 ms
  for (const Hit& hit : {hit_of(row), find_hits(test::force_record(kFs_Hz, {row}), {.trigger_N = 20}).at(0)}) {
    const Finding* const finding = only(hit, FindingCode::no_pulse);
    ASSERT_NE(finding, nullptr);
    EXPECT_EQ(finding->message,
              "no hammer pulse: the force of 50 N lasts longer than a hammer's contact; check the hammer's cable and "
              "channel");
    EXPECT_TRUE(finding->options.empty());
  }
}

TEST(HitFindings, SayThatTheForceStaysAtRest) {
  std::vector<double> row(kSamples);
  test::add_noise(row, 0.3, 9);
  EXPECT_THAT(hit_of(row).findings.at(0).message, testing::HasSubstr("stays within"));
  test::add_haversine(row, 2000, 0.1 * kFs_Hz, 50);
  const Hit below = find_hits(test::force_record(kFs_Hz, {row}), {.trigger_N = 200}).at(0);
  EXPECT_THAT(below.findings.at(0).message, testing::AllOf(testing::HasSubstr("stays within"),
                                                           testing::HasSubstr("check the trigger level of 200 N")));
}

TEST(HitFindings, ReportAWeakHit) {
  const Hit hit = hit_of(good_row(500, 200 * 0.15));
  const Finding* finding = only(hit, FindingCode::weak);
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->severity, Severity::warn);
  EXPECT_LE(std::abs(finding->value - 0.15), 0.01);  // peaks between samples
  EXPECT_TRUE(hit_of(good_row(500, 200 * 0.25)).findings.empty());
}

TEST(HitFindings, DistinguishAClippedForceFromAQuantisedOne) {
  auto clipped = good_row(), quantised = good_row();
  for (double& value : clipped) value = std::min(value, 120.0);
  for (double& value : quantised) value = std::round(value / 0.1) * 0.1;
  const Hit hit = hit_of(clipped);
  const Finding* finding = only(hit, FindingCode::overload);
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->severity, Severity::reject);
  EXPECT_EQ(finding->value, static_cast<double>(std::count(clipped.begin(), clipped.end(), 120.0)));
  EXPECT_TRUE(hit_of(quantised).findings.empty());
}

TEST(HitFindings, WarnOfANegativeForce) {
  auto row = good_row();
  for (double& value : row) value = -value;
  const Hit hit = hit_of(row);
  ASSERT_NE(only(hit, FindingCode::polarity), nullptr);
  EXPECT_EQ(hit.findings[0].severity, Severity::warn);
  EXPECT_EQ(hit.findings[0].value, hit.peak_N);
  EXPECT_LE(hit.peak_N, -190);
}

TEST(HitFindings, AcceptTheUndershootOfAnAcCoupledForce) {
  for (const double time_constant : {100.0, 1000.0}) {
    EXPECT_TRUE(hit_of(test::ac_coupled(good_row(), time_constant)).findings.empty()) << time_constant;
  }
}

TEST(HitFindings, AcceptAPulseAtTheVeryEnd) {
  for (const std::size_t left : {0U, 1U, 5U}) {
    std::vector<double> row(kSamples);
    row[kSamples - 1 - left] = 200;
    for (const Hit& hit : {hit_of(row), find_hits(test::force_record(kFs_Hz, {row})).at(0)}) {
      EXPECT_TRUE(hit.findings.empty());
      EXPECT_EQ(hit.peak, kSamples - 1 - left);
      EXPECT_EQ(hit.first + hit.samples, kSamples);
    }
  }
}

// A second contact excites the response, however late it comes. A late force below 5 % of the peak is not reported: it
// may come from the hand on the hammer.
TEST(HitFindings, ReportALateSecondHit) {
  const std::size_t late = kSamples - 1000;
  for (const double ratio : {0.06, 0.7, 0.04}) {
    auto row = good_row();
    test::add_filtered_haversine(row, static_cast<double>(late) + 0.3, 8, 200 * ratio);
    test::add_noise(row, 0.02, 3);
    const Hit hit = hit_of(row);
    const Finding* finding = only(hit, FindingCode::double_hit);
    ASSERT_EQ(finding != nullptr, ratio > 0.05) << ratio;
    if (finding == nullptr) continue;
    EXPECT_EQ(finding->severity, Severity::reject);
    EXPECT_NEAR(*finding->delay_s, (static_cast<double>(late) - 500) / kFs_Hz, 1 / kFs_Hz);
  }
}

TEST(HitFindings, LeaveOutALateSpike) {
  auto row = good_row();
  row[kSamples - 1000] += 60;
  EXPECT_TRUE(hit_of(row).findings.empty());
}

TEST(HitFindings, AgreeWithTheFaultsOfASyntheticTest) {
  synth::SynthSpec spec;
  spec.samples = 8192;
  spec.hits = 6;
  spec.noise = {.force = 1e-3, .accel = 1e-3};
  spec.modes = {{.freq_Hz = 169, .damping_ratio = 0.01}};
  spec.faults = {{.hit = 1, .kind = synth::SynthFaultKind::double_hit, .ratio = 0.3, .delay_s = 0.0123},
                 {.hit = 2, .kind = synth::SynthFaultKind::weak, .ratio = 0.1},
                 {.hit = 3, .kind = synth::SynthFaultKind::missing},
                 {.hit = 4, .kind = synth::SynthFaultKind::reversed},
                 {.hit = 5, .kind = synth::SynthFaultKind::late, .delay_s = 0.1e-3}};
  const synth::SyntheticTest test = synth::synthesise(spec);
  const auto hits = find_hits(test.record);
  ASSERT_EQ(hits.size(), 6U);
  EXPECT_TRUE(hits[0].findings.empty());
  const Finding* second = only(hits[1], FindingCode::double_hit);
  ASSERT_NE(second, nullptr);
  EXPECT_LE(std::abs(*second->delay_s - 0.0123), 1 / kFs_Hz);
  EXPECT_NE(only(hits[2], FindingCode::weak), nullptr);
  EXPECT_NE(only(hits[3], FindingCode::no_pulse), nullptr);
  EXPECT_NE(only(hits[4], FindingCode::polarity), nullptr);
  EXPECT_NE(found(hits[5], FindingCode::late_trigger), nullptr);
}

TEST(GradeBandwidth, WarnsWhenTheForceEndsBelowTheBand) {
  std::vector<Hit> hits = {{.peak_N = 100, .bandwidth_Hz = 3000}, {.peak_N = 100, .bandwidth_Hz = 3200}, {}};
  grade_bandwidth(hits, 3200);
  ASSERT_NE(only(hits[0], FindingCode::low_bandwidth), nullptr);
  EXPECT_EQ(hits[0].findings[0].value, 3000);
  EXPECT_EQ(hits[0].findings[0].severity, Severity::warn);
  EXPECT_TRUE(hits[1].findings.empty());
  EXPECT_TRUE(hits[2].findings.empty());  // a hit without a pulse has the finding no_pulse
}

}  // namespace percuss::acquire::hits_grade_test
