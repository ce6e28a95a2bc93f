#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "metrics/deflection/baseline_blocks.hpp"
#include "metrics/deflection/baseline_drift.hpp"

namespace percuss::metrics {

/// An acceleration from the end of the samples at rest on, less the line through them.
struct MovingSignal {
  double fs_Hz = 0, highpass_corner_Hz = 0;
  std::span<const double> accel_mps2;
  /// integrate_twice of accel_mps2, less the rigid-body deflection of a free body.
  std::span<const double> deflection_m;
  bool may_return = false;  // false: a free body; its late deflection says nothing of the baseline
};

/// The error of an acceleration whose noise rises at low frequencies:
///   e(t) = bias + drift·t + white noise + 1/f noise of the power spectral density K/f                        (1)
/// Two kinds of observations determine it: the means of blocks of the samples at rest, and Hann-weighted means of the
/// deflection of a structure that swings about its position of rest, each over four periods or more of its strongest
/// motion. Such means are zero but for leakage, and for the integral of e. The observations are jointly normal, so e is
/// estimated by linear regression (kriging); bias and drift are unknown constants. theory (7.11), (7.12)
class BaselineNoise {
 public:
  /// Needs 64 samples at rest with some noise and no hum; see usable().
  BaselineNoise(const BaselineEstimate& rest, const MovingSignal& signal);

  bool usable() const { return usable_; }
  /// Whether the late deflection agrees with a structure that swings about its position of rest.
  bool returns_to_rest() const { return returns_; }
  /// The natural logarithm of the likelihood at each flicker strength, over its value at white noise alone. Empty where
  /// not usable. shapes [kFlickerStrengths].
  const std::vector<double>& log_gains() const { return log_gains_; }

  struct Error {
    std::vector<double> accel_mps2;  // estimate of e without its white noise
    std::vector<double> std_m;       // of the deflection less the double integral of this estimate
    double drift_std_m = 0;          // std_m of the last sample, without the white noise
  };
  /// The error at the samples of the moving signal, for 1/f noise of this strength K > 0. Nothing where not usable.
  std::optional<Error> error_at(double strength) const;

 private:
  struct Observations {
    Eigen::VectorXd value;
    Eigen::MatrixXd by_line;    // of bias and drift [observations × 2]
    Eigen::MatrixXd by_block;   // [observations × blocks]
    Eigen::MatrixXd white;      // covariance for white noise with the variance 1 of a sample
    Eigen::MatrixXd flicker;    // covariance for 1/f noise with K = 1
    Eigen::VectorXd leakage_m;  // standard deviations
  };
  struct Regression;

  void observe_rest(const std::vector<double>& residual_mps2);
  void observe_windows(const MovingSignal& signal, double lowest_Hz);
  Regression regression(Eigen::Index observations, double strength, double noise_mps2) const;
  std::vector<double> log_likelihoods(Eigen::Index observations) const;
  double mean_strength(const std::vector<double>& log_likelihoods) const;

  double fs_Hz_, corner_Hz_;
  std::size_t samples_;
  bool usable_ = false, returns_ = false;
  double sample_noise_mps2_ = 0;
  BaselineBlocks blocks_;
  Eigen::MatrixXd flicker_;
  Observations seen_;
  Eigen::Index at_rest_ = 0;  // observations at rest, the first ones
  std::vector<double> log_gains_;
};

/// The strengths K at which signals are compared, in (m/s²)²; ascending.
inline constexpr std::size_t kFlickerStrengths = 241;
double flicker_strength_at(std::size_t i);

/// The strength of the 1/f noise that several signals of one sensor show: the mean over the strengths that are likelier
/// than white noise, each weighted with its likelihood. 0 where no strength is e³ = 20 times as likely as white noise.
/// log_gains: the sum of BaselineNoise::log_gains() over the signals, or empty.
double flicker_strength(std::span<const double> log_gains);

}  // namespace percuss::metrics
