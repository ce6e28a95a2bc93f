#include "identify/start/lscf.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/math/fft.hpp"
#include "core/math/roots.hpp"
#include "core/units.hpp"
#include "identify/noise/line_noise.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

// Free part of the circle times the model order. With less, the two ends of the band cannot differ; with more, the
// powers of z become nearly linearly dependent at the lines.
constexpr double kGap = 8;
constexpr double kMaxGap = 0.3;
constexpr std::size_t kMaxModelOrder = 100;
constexpr std::size_t kLinesPerOrder = 4;
constexpr double kRidge =
    1e-15;  // of the diagonal: moves the superfluous poles of noise-free data far outside the circle
constexpr double kRidgeGrowth = 4;    // factor of the ridge after a failed factorisation
constexpr double kNoiseFloor = 1e-6;  // of an FRF's largest line
constexpr double kStartRadius = 0.6;  // radius of the start of each new root; noise roots lie there or further inside
constexpr double kGoldenAngle = 2.39996;

// The map from the lines to the circle: z = exp((s − j·first)·step).
struct Circle {
  std::size_t points = 0;
  std::size_t lines = 0;
  double first_radps = 0;
  double step_s = 0;
};

Circle circle_of(const acquire::LineRange& lines, const LscfOptions& options) {
  const double gap = std::min(kMaxGap, kGap / static_cast<double>(options.max_order));
  const auto points = static_cast<std::size_t>(std::ceil(static_cast<double>(options.count) / (1 - gap)));
  Circle circle{.points = std::max(fast_length_at_most(points), options.count + 1), .lines = options.count};
  circle.first_radps = kTwoPi * lines.freq_Hz(options.first);
  circle.step_s = 1 / (static_cast<double>(circle.points) * lines.df_Hz());
  return circle;
}

// Σ_k x_k z_k^m over the lines, m = −degree … degree.
class PowerSums {
 public:
  PowerSums(const Circle& circle, std::size_t degree)
      : lines_(circle.lines),
        degree_(static_cast<Index>(degree)),
        values_(circle.points),
        transform_(circle.points / 2 + 1) {}

  template <class Value>
  VectorXcd of(Value&& value) {
    for (std::size_t k = 0; k < lines_; ++k) values_[k] = value(k);  // zero beyond the lines
    real_dft(values_, transform_);
    VectorXcd sums(2 * degree_ + 1);
    for (Index m = 0; m <= degree_; ++m) {
      sums(degree_ + m) = std::conj(transform_[static_cast<std::size_t>(m)]);
      sums(degree_ - m) = transform_[static_cast<std::size_t>(m)];
    }
    return sums;
  }

  // Σ_k conj(z_k^i) x_k z_k^l at (i, l).
  MatrixXcd toeplitz(const VectorXcd& sums) const {
    MatrixXcd matrix(degree_ + 1, degree_ + 1);
    for (Index l = 0; l <= degree_; ++l) matrix.col(l) = sums.segment(l, degree_ + 1).reverse();
    return matrix;
  }

 private:
  std::size_t lines_;
  Index degree_;
  std::vector<double> values_;
  std::vector<Complex> transform_;
};

double peak_magnitude(std::span<const Complex> lines) {
  double largest = 0;
  for (const Complex& line : lines) largest = std::max(largest, std::abs(line));
  return largest;
}

// (3) as a quadratic form of the coefficients of A, with B_o eliminated: lower triangle of [max_order + 1]².
MatrixXcd normal_matrix(const FrfDataset& set, const LscfOptions& options, const Circle& circle) {
  PowerSums sums(circle, options.max_order);
  const Eigen::LLT<MatrixXcd> powers(sums.toeplitz(sums.of([](std::size_t) { return 1.0; })));
  const Eigen::VectorXd noise = LineNoise(set).over(options.first, options.count);
  const auto size = static_cast<Index>(options.max_order + 1);
  MatrixXcd matrix = MatrixXcd::Zero(size, size);
  for (std::size_t o = 0; o < set.channels.size(); ++o) {
    const auto h = std::span(set.channels[o].frf).subspan(options.first, options.count);
    const double largest = peak_magnitude(h);
    if (!(largest > 0)) continue;
    const double root = 1 / std::max(noise(static_cast<Index>(o)), kNoiseFloor * largest);  // √w_o
    const VectorXcd real = sums.of([&](std::size_t k) { return root * h[k].real(); });
    const VectorXcd imag = sums.of([&](std::size_t k) { return root * h[k].imag(); });
    MatrixXcd numerator = sums.toeplitz(real + Complex(0, 1) * imag);
    powers.matrixL().solveInPlace(numerator);
    matrix += sums.toeplitz(sums.of([&](std::size_t k) { return std::norm(root * h[k]); }));
    matrix.selfadjointView<Eigen::Lower>().rankUpdate(numerator.adjoint(), -1);
  }
  return matrix;
}

MatrixXcd factor_of(const MatrixXcd& matrix) {
  double ridge = kRidge;
  while (ridge < 1) {
    MatrixXcd ridged = matrix;
    ridged.diagonal() *= 1 + ridge;
    const Eigen::LLT<MatrixXcd> factor(ridged);
    if (factor.info() == Eigen::Success) return factor.matrixL();
    ridge *= kRidgeGrowth;
  }
  return {};
}

// The poles of 1/A from the roots of its mirror image w^n A(1/w).
std::vector<Pole> poles_of(const VectorXcd& w, const Circle& circle, double window_decay_per_s) {
  std::vector<Pole> poles;
  for (const Complex& root : w) {
    double angle = -std::arg(root);
    if (angle < 0) angle += kTwoPi;
    const bool within = angle * static_cast<double>(circle.points) <= kTwoPi * static_cast<double>(circle.lines - 1);
    if (!within || !(std::abs(root) > 0)) continue;
    const Complex s(-std::log(std::abs(root)) / circle.step_s + window_decay_per_s,
                    circle.first_radps + angle / circle.step_s);
    const Pole pole{.freq_Hz = std::abs(s) / kTwoPi, .damping_ratio = -s.real() / std::abs(s)};
    if (pole.damping_ratio > 0 && pole.damping_ratio < kMaxDampingRatio) poles.push_back(pole);
  }
  std::sort(poles.begin(), poles.end(), [](const Pole& a, const Pole& b) { return a.freq_Hz < b.freq_Hz; });
  return poles;
}

}  // namespace

std::vector<LscfOrder> lscf_poles(const FrfDataset& set, const LscfOptions& asked) {
  LscfOptions options = asked;
  options.first = std::min(asked.first, set.lines.count);
  const std::size_t left = set.lines.count - options.first;
  options.count = asked.count == 0 ? left : std::min(asked.count, left);
  options.max_order = std::min({asked.max_order, options.count / kLinesPerOrder, kMaxModelOrder});
  if (options.max_order < 2 || set.channels.empty()) return {};
  const Circle circle = circle_of(set.lines, options);
  const MatrixXcd matrix = normal_matrix(set, options, circle);
  const auto n = static_cast<Index>(options.max_order);
  const MatrixXcd factor = factor_of(matrix.bottomRightCorner(n, n));
  if (factor.size() == 0) return {};
  // The leading block of the factor is the factor of the leading block, the equations of a lower order.
  const VectorXcd right = factor.triangularView<Eigen::Lower>().solve(-matrix.col(0).tail(n));
  std::vector<LscfOrder> out;
  VectorXcd w(1);
  w << kStartRadius;
  for (Index order = 2; order <= n; ++order) {
    const VectorXcd a =
        factor.topLeftCorner(order, order).adjoint().triangularView<Eigen::Upper>().solve(right.head(order));
    w.conservativeResize(order);
    w(order - 1) = std::polar(kStartRadius, kGoldenAngle * static_cast<double>(order));
    w = polynomial_roots(a, w);
    out.push_back({.order = static_cast<std::size_t>(order), .poles = poles_of(w, circle, set.window_decay_per_s())});
  }
  return out;
}

}  // namespace percuss::identify
