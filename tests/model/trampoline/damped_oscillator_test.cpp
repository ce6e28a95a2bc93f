#include "model/trampoline/damped_oscillator.hpp"

#include <gtest/gtest.h>

namespace percuss::model::damped_oscillator_test {

// Against its own differential equation, by central differences, in each of the three ranges of damping.
TEST(DampedOscillator, SolvesItsDifferentialEquation) {
  for (const double decay : {0.0, 0.3, 2.0, 2.5}) {
    const DampedOscillator oscillator{.omega_radps = 2, .decay_radps = decay};
    const OscillatorState start{.x_m = 0.7, .v_mps = -1.1};
    EXPECT_EQ(oscillator.after(start, 0).x_m, start.x_m);
    EXPECT_EQ(oscillator.after(start, 0).v_mps, start.v_mps);
    const double t = 0.8, h = 1e-5;
    const auto before = oscillator.after(start, t - h), now = oscillator.after(start, t),
               later = oscillator.after(start, t + h);
    constexpr double kDifferences = 1e-9;  // h² and rounding over h
    EXPECT_NEAR((later.x_m - before.x_m) / (2 * h), now.v_mps, kDifferences);
    EXPECT_NEAR((later.v_mps - before.v_mps) / (2 * h), -2 * decay * now.v_mps - 4 * now.x_m, kDifferences);
  }
}

}  // namespace percuss::model::damped_oscillator_test
