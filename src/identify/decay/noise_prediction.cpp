#include "identify/decay/noise_prediction.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/math/fft.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr std::size_t kOrder = 16;
// Added to the variance, relative to it: keeps the equations solvable without noise at some frequencies.
constexpr double kLoad = 1e-9;

}  // namespace

double NoisePrediction::error(const std::vector<double>& x, std::size_t n) const {
  double out = x[n];
  for (std::size_t i = 1; i <= weight.size() && n + i < x.size(); ++i) out -= weight[i - 1] * x[n + i];
  return out;
}

double NoisePrediction::gain(const DecayRate& rate, double fs_Hz) const {
  const Complex step = std::exp(rate.rate_radps / fs_Hz);
  Complex sum = 1, power = 1;
  for (const double one : weight) {
    power *= step;
    sum -= one * power;
  }
  return std::norm(sum);
}

NoisePrediction noise_prediction(const Eigen::VectorXd& line_variance, std::size_t samples) {
  const std::vector<Complex> lines(line_variance.data(), line_variance.data() + line_variance.size());
  const std::vector<double> correlation = inverse_real_dft(lines, samples);  // times `samples`
  const auto order = static_cast<Index>(std::min(kOrder, samples / 4));
  Eigen::MatrixXd matrix(order, order);
  Eigen::VectorXd right(order);
  for (Index i = 0; i < order; ++i) {
    right(i) = correlation[static_cast<std::size_t>(i + 1)];
    for (Index j = 0; j < order; ++j) matrix(i, j) = correlation[static_cast<std::size_t>(std::abs(i - j))];
    matrix(i, i) *= 1 + kLoad;
  }
  const Eigen::VectorXd weight = matrix.ldlt().solve(right);
  NoisePrediction out{.weight = {}, .error_variance = correlation.front() / static_cast<double>(samples)};
  if (!weight.allFinite()) return out;
  out.weight.assign(weight.data(), weight.data() + order);
  out.error_variance *= std::max(kLoad, 1 - right.dot(weight) / correlation.front());
  return out;
}

}  // namespace percuss::identify
