#include "pipeline/warnings/force_findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"
#include "support/force_row.hpp"
#include "support/messages.hpp"

namespace percuss::pipeline::force_findings_test {

using std::numbers::pi;
using testing::Contains;
using testing::Not;

constexpr double kRate_Hz = 2048, kPeak_N = 60;
constexpr std::size_t kSamples = 1024, kFine = 16;  // kFine: values per sample of the signal before the recorder
constexpr double kOnset = 150;

// What the recorder does before it samples, for a signal of kFine values per sample.
using Filter = std::function<std::vector<double>(const std::vector<double>&)>;

std::vector<double> no_filter(const std::vector<double>& x) { return x; }

// A converter's linear-phase filter of 64 samples: it passes 0.45 of the sampling rate, has −6 dB at half the rate, and
// stops from 0.55 on.
std::vector<double> half_band(const std::vector<double>& x) {
  constexpr double kHalf = 32;
  constexpr auto kTaps = static_cast<std::size_t>(2 * kHalf) * kFine;
  std::vector<double> kernel(kTaps + 1), out(x.size());
  for (std::size_t k = 0; k <= kTaps; ++k) {
    const double u = static_cast<double>(k) / static_cast<double>(kFine) - kHalf;
    const double sinc = u == 0 ? 1 : std::sin(pi * u) / (pi * u);
    kernel[k] = sinc * (0.42 + 0.5 * std::cos(pi * u / kHalf) + 0.08 * std::cos(2 * pi * u / kHalf)) / kFine;
  }
  for (std::size_t n = 0; n < x.size(); ++n) {
    if (x[n] == 0) continue;
    for (std::size_t k = 0; k <= kTaps; ++k) {
      const std::size_t at = n + k;
      if (at >= kTaps / 2 && at - kTaps / 2 < out.size()) out[at - kTaps / 2] += kernel[k] * x[n];
    }
  }
  return out;
}

// A first-order low-pass with its corner at 0.4 of the sampling rate: far from steep.
std::vector<double> first_order(const std::vector<double>& x) {
  const double keep = std::exp(-2 * pi * 0.4 / kFine);
  std::vector<double> out(x.size());
  for (std::size_t n = 1; n < x.size(); ++n) out[n] = keep * out[n - 1] + (1 - keep) * x[n];
  return out;
}

// Hits by pulses of `width` samples, each with another time between two samples. The responses hold a mode just below
// half the sampling rate in either case.
acquire::Record test_of(double width, const Filter& filter, std::size_t hits = 5) {
  std::vector<std::vector<double>> force_N;
  std::vector<std::vector<std::vector<double>>> accel_mps2;
  for (std::size_t h = 0; h < hits; ++h) {
    const double onset = kOnset + 0.17 + 0.2 * static_cast<double>(h);
    std::vector<double> fine(kSamples * kFine), force(kSamples), accel(kSamples);
    test::add_haversine(fine, onset * kFine, width * kFine, kPeak_N);
    fine = filter(fine);
    for (std::size_t n = 0; n < kSamples; ++n) {
      force[n] = fine[n * kFine];
      const double t = static_cast<double>(n) - onset - width;
      if (t > 0) accel[n] = 50 * std::exp(-0.01 * t) * (std::sin(2 * pi * 0.1 * t) + 0.5 * std::sin(2 * pi * 0.47 * t));
    }
    test::add_noise(force, 1e-3 * kPeak_N, 2 * h + 1);
    test::add_noise(accel, 0.02, 2 * h + 2);
    force_N.push_back(std::move(force));
    accel_mps2.push_back({std::move(accel)});
  }
  return acquire::record_in_memory(kRate_Hz, std::move(force_N), std::move(accel_mps2));
}

std::vector<std::string> codes_of(acquire::Record record) {
  const Analysis analysis(std::move(record), {.band_Hz = std::pair{15.0, 750.0}, .threads = 1});
  analysis.frfs();
  return test::codes_of(analysis.warnings());
}

class ShortPulse : public testing::TestWithParam<double> {};

TEST_P(ShortPulse, ShowsThatNoFilterActs) {
  EXPECT_THAT(codes_of(test_of(GetParam(), no_filter)), Contains("aliasing"));
  EXPECT_THAT(codes_of(test_of(GetParam(), first_order)), Contains("aliasing"));
}

// The spectrum of the pulse reaches half the sampling rate, folded, but nothing below 0.45 of the rate is folded.
TEST_P(ShortPulse, ShowsThatAHalfBandFilterActs) {
  EXPECT_THAT(codes_of(test_of(GetParam(), half_band)), Not(Contains("aliasing")));
}

INSTANTIATE_TEST_SUITE_P(Aliasing, ShortPulse, testing::Values(1.2, 2.0, 2.5));

// A hammer that rings at a high frequency after its contact does not hide a missing filter.
TEST(Aliasing, IsNamedAlthoughTheHammerRings) {
  const auto ringing = [](std::vector<double> x) {
    const auto contact = static_cast<std::size_t>((kOnset + 3) * kFine);
    for (std::size_t n = contact; n < x.size(); ++n) {
      const double t = static_cast<double>(n - contact) / kFine;
      x[n] += 0.01 * kPeak_N * std::exp(-0.3 * t) * std::sin(2 * pi * 0.43 * t);
    }
    return x;
  };
  EXPECT_THAT(codes_of(test_of(2, ringing)), Contains("aliasing"));
}

}  // namespace percuss::pipeline::force_findings_test
