#include "metrics/deflection/integration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace percuss::metrics::integration_test {

constexpr double kFs_Hz = 2000;
constexpr std::size_t kSamples = 3000;
constexpr double kFreq_Hz = 37, kDecay_per_s = 9;

/// A motion with known derivatives, band-limited to within 1e-12: w = g(t) sin(ωt). g is a Gaussian pulse of 60 ms, far
/// from both ends.
struct Truth {
  std::vector<double> accel, velocity, deflection;
};

struct MotionAt {
  double accel = 0, velocity = 0, deflection = 0;
};

MotionAt motion_at(double time_s) {
  const double omega = kTwoPi * kFreq_Hz, width_s = 0.06, t = time_s - 0.6, x = t / width_s;
  const double g = std::exp(-x * x / 2), g1 = -x / width_s * g, g2 = (x * x - 1) / (width_s * width_s) * g;
  const double s = std::sin(omega * t), c = std::cos(omega * t);
  return {.accel = g2 * s + 2 * g1 * omega * c - g * omega * omega * s,
          .velocity = g1 * s + g * omega * c,
          .deflection = g * s};
}

Truth truth() {
  Truth out;
  for (std::size_t i = 0; i < kSamples; ++i) {
    const MotionAt at = motion_at(static_cast<double>(i) / kFs_Hz);
    out.deflection.push_back(at.deflection);
    out.velocity.push_back(at.velocity);
    out.accel.push_back(at.accel);
  }
  return out;
}

double furthest(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

// Rounding of 1e-16, amplified by e^15, the inverse of the integration's exponential window. It applies to an
// acceleration of 5e4 divided by ω².
constexpr double kRounding = 1e-8;

TEST(IntegrateTwice, IsExactForABandLimitedMotion) {
  const Truth t = truth();
  const Motion motion = integrate_twice(t.accel, kFs_Hz);
  EXPECT_LE(furthest(motion.deflection_m, t.deflection), kRounding);
  EXPECT_LE(furthest(motion.velocity_mps, t.velocity), kRounding * kTwoPi * kFreq_Hz);
}

TEST(IntegrateTwice, CompensatesTheHighPassOfAChargeAmplifier) {
  // A first-order high-pass with its corner at 5 Hz: y' + ω_c y = a', so y = a − z with z' = ω_c (a − z).
  const double corner_Hz = 5, corner = kTwoPi * corner_Hz;
  const Truth t = truth();
  // z is integrated by RK4 from the closed form of a(t), 20 steps per sample, independently of the Laplace transform.
  std::vector<double> y;
  double z = 0;
  const int steps = 20;
  const double h = 1 / kFs_Hz / steps;
  for (std::size_t i = 0; i < kSamples; ++i) {
    y.push_back(t.accel[i] - z);
    for (int k = 0; k < steps; ++k) {
      const double at = static_cast<double>(i) / kFs_Hz + k * h;
      const auto slope = [&](double time_s, double value) { return corner * (motion_at(time_s).accel - value); };
      const double k1 = slope(at, z), k2 = slope(at + h / 2, z + h / 2 * k1), k3 = slope(at + h / 2, z + h / 2 * k2),
                   k4 = slope(at + h, z + h * k3);
      z += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
  }
  const Motion motion = integrate_twice(y, kFs_Hz, corner_Hz);
  constexpr double kTolerance = 1e-7;  // error of RK4, fourth order in ω·h = 0.006, integrated twice
  EXPECT_LE(furthest(motion.deflection_m, t.deflection), kTolerance);
  constexpr double kUncompensated = 0.05;  // the error without compensation is several per cent
  EXPECT_GE(furthest(integrate_twice(y, kFs_Hz).deflection_m, t.deflection), kUncompensated);
}

TEST(IntegrateTwice, TurnsAStepIntoAParabola) {
  // The band limit rounds the corner of a step. So the integral differs from the sum of the samples by half of the
  // first sample.
  const std::vector<double> ones(1000, 1.0);
  const Motion motion = integrate_twice(ones, 1000);
  EXPECT_NEAR(motion.velocity_mps[500], 0.5, 1e-3);
  EXPECT_NEAR(motion.deflection_m[500], 0.125, 1e-3);
}

TEST(SmallIntervalSums, ConvergeAtFirstOrder) {
  std::vector<double> errors;
  for (const double fs_Hz : {1000.0, 2000.0, 4000.0}) {
    std::vector<double> accel;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(fs_Hz); ++i)
      accel.push_back(std::exp(-kDecay_per_s * static_cast<double>(i) / fs_Hz));
    const double exact = 1 / kDecay_per_s - (1 - std::exp(-kDecay_per_s)) / (kDecay_per_s * kDecay_per_s);
    errors.push_back(std::abs(small_interval_sums(accel, fs_Hz).deflection_m.back() - exact));
  }
  EXPECT_NEAR(errors[0] / errors[1], 2, 0.05);
  EXPECT_NEAR(errors[1] / errors[2], 2, 0.05);
}

TEST(IntegrateInFrequencyDomain, IsExactForASignalPeriodicInTheRecord) {
  std::vector<double> accel, deflection;
  const double omega = kTwoPi * 8;
  for (std::size_t i = 0; i < 1000; ++i) {
    deflection.push_back(std::sin(omega * static_cast<double>(i) / 1000));
    accel.push_back(-omega * omega * deflection.back() + 3);  // and a bias
  }
  EXPECT_LE(furthest(integrate_in_frequency_domain(accel, 1000, 0, 4).deflection_m, deflection), kRounding);
  EXPECT_LE(furthest(integrate_in_frequency_domain(accel, 1000, 0, 9).deflection_m, std::vector<double>(1000)),
            kRounding);
}

}  // namespace percuss::metrics::integration_test
