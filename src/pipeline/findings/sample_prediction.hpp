#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace percuss::pipeline {

/// Linear predictions of a sum of decaying oscillations: from the samples before, and from the samples after.
struct SamplePrediction {
  Eigen::VectorXd forward, backward;              // [order] weights, the nearest sample first
  std::vector<double> forward_std, backward_std;  // [channels] robust, of the errors
};
inline constexpr std::size_t kPredictionOrder = 40;
/// Samples on either side of a suspect sample that a diagnosis needs: 44 that it searches, 40 of the longest fault, and
/// the samples of the predictions.
inline constexpr std::size_t kDiagnosisRoom = 84 + 2 * kPredictionOrder;

/// x[n] − its prediction. n needs kPredictionOrder samples before it, or after it.
double forward_error(const SamplePrediction& prediction, std::span<const double> x, std::size_t n);
double backward_error(const SamplePrediction& prediction, std::span<const double> x, std::size_t n);

/// Whether fit_prediction() with these arguments has enough samples.
bool can_fit_prediction(std::size_t first, std::size_t end, std::size_t at, std::size_t gap);

/// Fits the predictions to the samples [first, end) of all channels, without samples nearer to `at` than `gap`. Nothing
/// when too few samples remain.
std::optional<SamplePrediction> fit_prediction(std::span<const std::span<const double>> channels, std::size_t first,
                                               std::size_t end, std::size_t at, std::size_t gap);

/// Interpolated samples, and the scaled errors of the prediction around them: errors over their standard deviation.
struct Interpolation {
  Eigen::VectorXd samples;
  double square = 0;        // sum of squares of the scaled errors
  std::size_t freedom = 0;  // number of errors minus number of unknowns
};
/// Values for `count` samples of x from sample `before` on, which make the errors of the prediction around them least.
/// The recorded values of these samples have no effect. Near an end of x, fewer errors determine them: at the first
/// sample only the errors of the backward prediction. x must hold kPredictionOrder samples before or after them.
Interpolation interpolate_samples(const SamplePrediction& prediction, std::size_t channel, std::span<const double> x,
                                  std::size_t before, std::size_t count);

}  // namespace percuss::pipeline
