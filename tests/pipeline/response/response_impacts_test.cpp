#include "pipeline/response/response_impacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/units.hpp"
#include "pipeline/response/response_test.hpp"
#include "support/response_records.hpp"

// Weak blows are tested by the modes that are fitted to the decays after them.
namespace percuss::pipeline::response_impacts_test {

constexpr double kFs_Hz = 8192;

// A row with the free decay of a slow mode of amplitude 1 from 0.1 s on.
constexpr identify::Pole kSlow{40, 0.05};
std::vector<double> slow_decay(double noise, std::mt19937& random) {
  std::normal_distribution<double> gauss;
  const Complex s = identify::decay_rate_of(kSlow).rate_radps;
  std::vector<double> x(8192);
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double t_s = static_cast<double>(n) / kFs_Hz - 0.1;
    x[n] = 0.5 + noise * gauss(random) + (t_s < 0 ? 0 : std::exp(s * t_s).real());
  }
  return x;
}

// A slow mode ten times above the noise: noise hides the blow in the differences of the samples, but not in the
// samples. A fit that begins before the blow biases the damping ratio.
TEST(ResponseImpacts, FindsAWeakBlowOnASlowMode) {
  constexpr unsigned kSeeds = 60;
  double sum = 0, squares = 0;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    std::mt19937 random(seed);
    const ResponseTest test =
        analyse_responses(test::response_record(kFs_Hz, {{slow_decay(0.1, random)}}, 0, false), {});
    ASSERT_FALSE(test.hits.empty()) << seed;
    EXPECT_NEAR(test.hits[0].onset_s, 0.1, 2e-3) << seed;
    const auto near = std::find_if(test.found.modes.begin(), test.found.modes.end(),
                                   [](const auto& m) { return std::abs(m.mode.pole.freq_Hz - kSlow.freq_Hz) < 4; });
    ASSERT_NE(near, test.found.modes.end()) << seed;
    const double z = (near->mode.pole.damping_ratio - kSlow.damping_ratio) / near->mode.damping_std;
    sum += z;
    squares += z * z;
  }
  EXPECT_NEAR(sum / kSeeds, 0, 0.39);                 // three standard deviations of the mean of 60 values
  EXPECT_NEAR(std::sqrt(squares / kSeeds), 1, 0.28);  // and of their RMS
}

// The constant of the signal is no sign of a second mode. With these two of 400 seeds, it once counted as one, and no
// mode was found.
TEST(ResponseImpacts, IsNotSplitByAConstant) {
  for (const unsigned seed : {231U, 351U}) {
    std::mt19937 random(seed);
    const ResponseTest test =
        analyse_responses(test::response_record(kFs_Hz, {{slow_decay(0.1, random)}}, 0, false), {});
    ASSERT_EQ(test.found.modes.size(), 1U) << seed;
    EXPECT_NEAR(test.found.modes[0].mode.pole.freq_Hz, kSlow.freq_Hz, 4 * test.found.modes[0].mode.freq_std_Hz);
  }
}

// In a row that shows no blow, the blow may lie anywhere. Such a row is not used if other rows show their blows.
TEST(ResponseImpacts, RejectsRowsWithoutABlowIfOthersShowOne) {
  std::mt19937 random(1);
  const ResponseTest test = analyse_responses(
      test::response_record(kFs_Hz, {{slow_decay(0.01, random)}, {slow_decay(2, random)}}, 0, false), {});
  ASSERT_EQ(test.hits.size(), 2U);
  EXPECT_TRUE(test.hits[0].accepted);
  EXPECT_FALSE(test.hits[1].accepted);
  EXPECT_EQ(test.found.modes.size(), 1U);
}

}  // namespace percuss::pipeline::response_impacts_test
