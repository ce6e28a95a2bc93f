#include "pipeline/channels/align_record.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"

namespace percuss::pipeline::align_record_test {

constexpr double kRate_Hz = 1000;
constexpr std::size_t kSamples = 600;

double wave(double freq_Hz, double t_s) { return std::sin(kTwoPi * freq_Hz * t_s + 0.4) + 2; }

// One row with two channels, which come late by these times.
acquire::Record late(double freq_Hz, std::vector<double> delay_s) {
  std::vector<std::vector<double>> accel;
  for (const double delay : delay_s) {
    accel.emplace_back();
    for (std::size_t n = 0; n < kSamples; ++n)
      accel.back().push_back(wave(freq_Hz, static_cast<double>(n) / kRate_Hz - delay));
  }
  return acquire::record_in_memory(kRate_Hz, {std::vector<double>(kSamples)}, {accel});
}

TEST(AlignRecord, InterpolatesUpTo44PercentOfTheRate) {
  constexpr double kFilter = 2e-4;  // of the amplitude: the interpolation filter near its transition, at 440 Hz
  for (const double freq_Hz : {3.0, 120.0, 440.0}) {
    const acquire::Record record = late(freq_Hz, {0.00237, -0.00581});
    const acquire::Record aligned =
        align_record(record, {{.channel = 0, .delay_s = 0.00237}, {.channel = 1, .delay_s = -0.00581}});
    for (std::size_t channel = 0; channel < 2; ++channel) {
      std::vector<double> got(300);
      aligned.read_accel_mps2(0, channel, 150, got);
      for (std::size_t n = 0; n < got.size(); ++n)
        ASSERT_NEAR(got[n], wave(freq_Hz, static_cast<double>(150 + n) / kRate_Hz), kFilter)
            << freq_Hz << ' ' << channel;
    }
  }
}

TEST(AlignRecord, MovesWholeSamplesExactly) {
  const acquire::Record record = late(120, {0.004, 0});
  const acquire::Record aligned = align_record(record, {{.channel = 0, .delay_s = 0.004}});
  std::vector<double> moved(kSamples), stored(kSamples), other(kSamples);
  aligned.read_accel_mps2(0, 0, 0, moved);
  record.read_accel_mps2(0, 0, 0, stored);
  aligned.read_accel_mps2(0, 1, 0, other);
  for (std::size_t n = 0; n + 4 < kSamples; ++n) EXPECT_EQ(moved[n], stored[n + 4]);
  EXPECT_EQ(moved.back(), stored.back());
  record.read_accel_mps2(0, 1, 0, stored);
  EXPECT_EQ(other, stored);
  EXPECT_GE(samples_without_data({{.channel = 0, .delay_s = 0.004}}, kRate_Hz), 4U);
  EXPECT_EQ(samples_without_data({}, kRate_Hz), 0U);
}

TEST(AlignRecord, RefusesDelaysThatDoNotFit) {
  const acquire::Record record = late(120, {0, 0});
  EXPECT_EQ(stated_delays({1e-3}, record).size(), 2U);
  EXPECT_TRUE(stated_delays({}, record).empty());
  EXPECT_THROW(stated_delays({1e-3, 0, 0}, record), InputError);
  EXPECT_THROW(stated_delays({0.7}, record), InputError);
}

}  // namespace percuss::pipeline::align_record_test
