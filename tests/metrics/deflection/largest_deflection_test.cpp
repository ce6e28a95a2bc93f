#include "metrics/deflection/largest_deflection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "core/math/statistics.hpp"
#include "core/units.hpp"
#include "support/magnitude.hpp"

namespace percuss::metrics::largest_deflection_test {

// The pulse is long enough, in samples, that the record has hardly any aliasing: 10⁻⁵ of the deflection.
constexpr double kFs_Hz = 1024, kPulse_s = 0.024;

struct ForcedMode {
  double freq_Hz, damping, force_per_kg;
};

// Adds the closed form of x'' + 2ζωx' + ω²x = F (1 − cos(2πt/T))/2 for a force that starts at t = 0 and continues. The
// same force with the opposite sign, started T later, ends the pulse.
void add_started(const ForcedMode& mode, double sign, double t_s, double& x, double& a) {
  if (t_s <= 0) return;
  const double w = kTwoPi * mode.freq_Hz, d = mode.damping * w, wd = std::sqrt(w * w - d * d);
  const double p = kTwoPi / kPulse_s, re = w * w - p * p, im = 2 * d * p, norm = re * re + im * im;
  const double constant = 0.5 / (w * w), of_cosine = 0.5 * re / norm, of_sine = 0.5 * im / norm;
  const double c1 = of_cosine - constant, c2 = (of_sine * p + d * c1) / wd;
  const double e = std::exp(-d * t_s), sine = std::sin(wd * t_s), cosine = std::cos(wd * t_s);
  const double here =
      constant - of_cosine * std::cos(p * t_s) - of_sine * std::sin(p * t_s) + e * (c1 * cosine + c2 * sine);
  const double rate = p * (of_cosine * std::sin(p * t_s) - of_sine * std::cos(p * t_s)) +
                      e * ((-d * c1 + wd * c2) * cosine + (-d * c2 - wd * c1) * sine);
  const double force = sign * mode.force_per_kg;
  x += force * here;
  a += force * ((1 - std::cos(p * t_s)) / 2 - 2 * d * rate - w * w * here);
}

// A held beam that one pulse sets swinging.
struct Record {
  std::vector<double> accel_mps2, deflection_m;
};
Record record(const std::vector<ForcedMode>& modes, double rest_s, double length_s) {
  Record out;
  for (std::size_t n = 0; n < static_cast<std::size_t>(length_s * kFs_Hz); ++n) {
    const double t = static_cast<double>(n) / kFs_Hz - rest_s;
    double& a = out.accel_mps2.emplace_back();
    double& x = out.deflection_m.emplace_back();
    for (const ForcedMode& mode : modes) {
      add_started(mode, 1, t, x, a);
      add_started(mode, -1, t - kPulse_s, x, a);
    }
  }
  return out;
}

struct WeakRecords {
  const char* name;
  std::vector<ForcedMode> modes;
  double rest_s, length_s;
  double noise;  // over the RMS of the acceleration
};

// The errors of the largest deflections of many noisy records with an unknown bias.
struct Errors {
  std::vector<double> relative, in_stds;  // of the true largest deflection; in stated standard deviations
  double stated = 0;                      // mean of the stated standard deviation, relative

  double count() const { return static_cast<double>(relative.size()); }
  double mean() const { return std::accumulate(relative.begin(), relative.end(), 0.0) / count(); }
  double std_of_mean() const {
    double squares = 0;
    for (const double one : relative) squares += std::pow(one - mean(), 2);
    return std::sqrt(squares / (count() - 1) / count());
  }
  double rms_in_stds() const {
    return std::sqrt(std::inner_product(in_stds.begin(), in_stds.end(), in_stds.begin(), 0.0) / count());
  }
};

Errors errors_of(const WeakRecords& of, unsigned seed) {
  constexpr int kTrials = 200;
  const Record clean = record(of.modes, of.rest_s, of.length_s);
  const double true_m = test::largest_magnitude(clean.deflection_m);
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss;
  Errors out;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> accel = clean.accel_mps2;
    for (double& a : accel) a += 0.3 + of.noise * rms(clean.accel_mps2) * gauss(random);
    const Deflection found =
        deflection_of({.fs_Hz = kFs_Hz, .accel_mps2 = accel, .onset_s = of.rest_s, .force_N = {}, .modes = {}});
    EXPECT_TRUE(found.has_peak()) << of.name << ", " << trial;
    const double error_m = std::abs(found.peak_m) - true_m;
    out.relative.push_back(error_m / true_m);
    out.in_stds.push_back(error_m / found.peak_std_m);
    out.stated += found.peak_std_m / true_m / kTrials;
  }
  return out;
}

// The most significant value comes early; the largest comes a quarter of a slow period later. An estimate that took the
// time of the most significant value was 6.4 % low on average, and up to 5.3 standard deviations.
TEST(LargestDeflection, IsUnbiasedInWeakRecords) {
  constexpr double kMeanError = 3.3;  // standard errors: exceeded by one of four means once in 250 such tests
  // An RMS of 200 errors varies by 0.05. It is below 1 where the late deflection corrects the drift, theory (7.5).
  constexpr double kMaxRms = 1.2;
  constexpr double kFurthest = 4.6;  // standard deviations: exceeded by one of 800 errors once in 300 such tests
  const std::vector<ForcedMode> two{{6, 0.02, 60}, {41, 0.01, 80}}, quicker{{8, 0.02, 60}, {41, 0.01, 80}};
  unsigned seed = 3;
  for (const WeakRecords& of : std::vector<WeakRecords>{{"two modes", two, 0.1, 1.1, 0.05},
                                                        {"three swings", quicker, 0.1, 0.4, 0.002},
                                                        {"three swings, noisy", quicker, 0.1, 0.4, 0.02},
                                                        {"three slower swings", two, 0.1, 0.6, 0.003}}) {
    const Errors errors = errors_of(of, ++seed);
    EXPECT_GE(errors.stated, 0.001) << of.name;  // large enough to decide which sample counts as the largest
    EXPECT_LE(std::abs(errors.mean()), kMeanError * errors.std_of_mean()) << of.name;
    EXPECT_LE(errors.rms_in_stds(), kMaxRms) << of.name;
    for (const double z : errors.in_stds) EXPECT_LE(std::abs(z), kFurthest) << of.name;
  }
}

TEST(LargestDeflection, IsTheLargestSampleOfAClearRecord) {
  constexpr double kRest_s = 0.1;
  const Record clean = record({{6, 0.02, 60}, {41, 0.01, 80}}, kRest_s, 1.1);
  std::mt19937 random(4);
  std::normal_distribution<double> gauss;
  std::vector<double> accel = clean.accel_mps2;
  for (double& a : accel) a += 1e-4 * gauss(random);
  const Deflection found =
      deflection_of({.fs_Hz = kFs_Hz, .accel_mps2 = accel, .onset_s = kRest_s, .force_N = {}, .modes = {}});
  EXPECT_EQ(std::abs(found.peak_m), test::largest_magnitude(found.deflection_m));
}

// The decays of a weak record show when the largest deflection comes. The integral there may be lost in its drift: the
// value is then not known, and an earlier value that exceeds its ± is not the largest.
TEST(LargestDeflection, IsNotToldBelowFourOfItsStandardDeviations) {
  constexpr double kRest_s = 0.1;
  const Record clean = record({{6, 0.02, 60}, {41, 0.01, 80}}, kRest_s, 1.1);
  const auto& truth = clean.deflection_m;
  const double true_m = test::largest_magnitude(truth);
  const auto at = static_cast<std::size_t>(
      std::max_element(truth.begin(), truth.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      truth.begin());
  std::mt19937 random(4);
  std::normal_distribution<double> gauss;
  std::vector<double> accel = clean.accel_mps2;
  for (double& a : accel) a += 0.002 * rms(clean.accel_mps2) * gauss(random);
  const ImpactSignal signal{.fs_Hz = kFs_Hz, .accel_mps2 = accel, .onset_s = kRest_s, .force_N = {}, .modes = {}};
  const auto found_with = [&](double stds_at_largest) {
    Deflection found{.method = DeflectionMethod::drift_free, .deflection_m = truth};
    const double rest = kRest_s * kFs_Hz;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const double time = std::max(0.0, static_cast<double>(i) - rest) / (static_cast<double>(at) - rest);
      found.std_m.push_back(true_m / stds_at_largest * std::pow(time, 1.5));
    }
    find_largest(signal, {}, found);
    return found;
  };
  const Deflection known = found_with(5), unknown = found_with(3);
  EXPECT_NEAR(std::abs(known.peak_m), true_m, 0.02 * true_m);
  EXPECT_GT(std::abs(known.peak_m), 4 * known.peak_std_m);
  EXPECT_FALSE(unknown.has_peak());
  EXPECT_TRUE(std::isnan(unknown.peak_std_m) && std::isnan(unknown.forward_m) && std::isnan(unknown.forward_std_m));
}

}  // namespace percuss::metrics::largest_deflection_test
