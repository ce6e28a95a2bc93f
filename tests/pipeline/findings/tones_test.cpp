#include "pipeline/findings/tones.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "core/units.hpp"

namespace percuss::pipeline::tones_test {

constexpr double kFs_Hz = 10240, kMains_Hz = 49.98, kNoise = 0.1;
constexpr std::size_t kSamples = 10240, kOnset = 100;

struct Harmonic {
  double order, amplitude;
};
const std::vector<Harmonic> kHarmonics{{1, 3}, {2, 0.5}, {3, 1}, {5, 0.5}, {6, 0.4}};

// The deviation of a harmonic's phase from a steady one, in turns.
using Wander = std::function<double(double order, std::size_t n)>;

// Five hits with hum, and with modes at 120 and 310 Hz that still ring when the samples end, 20 and 10 Hz from the
// nearest harmonic.
std::vector<std::vector<double>> hits_in_hum(const Wander& wander) {
  std::mt19937 random(7);
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> any(0, 1);
  std::vector<std::vector<double>> hits;
  for (int h = 0; h < 5; ++h) {
    std::vector<double>& x = hits.emplace_back(kSamples);
    const double phase = any(random);
    for (std::size_t n = 0; n < kSamples; ++n) {
      const double t_s = static_cast<double>(n) / kFs_Hz;
      x[n] = kNoise * gauss(random);
      for (const auto& [order, amplitude] : kHarmonics)
        x[n] += amplitude * std::sin(kTwoPi * (order * (kMains_Hz * t_s + phase) + wander(order, n)));
      if (n < kOnset) continue;
      const double since_s = static_cast<double>(n - kOnset) / kFs_Hz;
      x[n] += 300 * std::exp(-3.0 * since_s) * std::sin(kTwoPi * 120 * since_s);
      x[n] += 500 * std::exp(-5.84 * since_s) * std::sin(kTwoPi * 310 * since_s);
    }
  }
  return hits;
}

ToneFit tones_of(const std::vector<std::vector<double>>& hits) {
  static const std::vector<double> pulse_N{1, 20, 60, 80, 60, 20, 1};
  std::vector<ToneSignal> signals;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    signals.push_back(
        {.x = hits[h], .hit = h, .pulse_N = pulse_N, .pulse_first = kOnset - 4, .quiet = kOnset - 4, .largest = 800});
  }
  return find_tones(signals, tone_candidates(hits.front()), kFs_Hz);
}

TEST(Tones, AreAllHarmonicsOfTheMainsBesideModesThatStillRing) {
  const ToneFit fit = tones_of(hits_in_hum([](double, std::size_t) { return 0.0; }));
  ASSERT_EQ(fit.tones.size(), kHarmonics.size());
  for (const auto& [order, amplitude] : kHarmonics) {
    const double freq_Hz = order * kMains_Hz;
    const auto tone = std::find_if(fit.tones.begin(), fit.tones.end(),
                                   [&](const Tone& one) { return std::abs(one.freq_Hz - freq_Hz) < 0.05; });
    ASSERT_NE(tone, fit.tones.end()) << freq_Hz;
    EXPECT_FALSE(tone->wanders) << freq_Hz;
    const auto t = static_cast<std::size_t>(tone - fit.tones.begin());
    for (const std::vector<Complex>& of_hit : fit.amplitudes)
      EXPECT_NEAR(std::abs(of_hit[t]), amplitude, 0.05 * amplitude) << freq_Hz;
  }
}

// A machine near a harmonic of the mains: its phase changes by a third of a turn within the record.
TEST(Tones, WanderWhereTheirPhaseDoes) {
  const ToneFit fit = tones_of(hits_in_hum([](double order, std::size_t n) {
    const double part = static_cast<double>(n) / kSamples;
    return order == 3 ? part * part / 3 : 0;
  }));
  const auto near = std::find_if(fit.tones.begin(), fit.tones.end(),
                                 [](const Tone& one) { return std::abs(one.freq_Hz - 3 * kMains_Hz) < 1; });
  ASSERT_NE(near, fit.tones.end());
  EXPECT_TRUE(near->wanders);
}

}  // namespace percuss::pipeline::tones_test
