#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/decay/decay_spectra.hpp"

namespace percuss::identify {

/// A linear prediction of stationary noise: a sample from the samples that follow it. Its errors are white.
///   e(n) = x(n) − Σ_i weight[i − 1] x(n + i),  i = 1 … order                                   (1)
/// theory (4.29)
struct NoisePrediction {
  std::vector<double> weight;  // [order]
  double error_variance = 0;

  /// The error (1) at sample n. Samples beyond the end of x count as zero: it is exact only for n + order < x.size().
  double error(const std::vector<double>& x, std::size_t n) const;
  /// |e/x|² of an oscillation x(n) = exp(s n Δ).
  double gain(const DecayRate& rate, double fs_Hz) const;
};

/// The prediction of noise of a given spectrum, from the Yule–Walker equations. `line_variance`: E|X(k)|² of the
/// one-sided lines of a transform of `samples` values, as decay_line_noise() gives it. shape [samples/2 + 1].
NoisePrediction noise_prediction(const Eigen::VectorXd& line_variance, std::size_t samples);

}  // namespace percuss::identify
