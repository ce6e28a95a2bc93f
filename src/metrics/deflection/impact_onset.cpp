#include "metrics/deflection/impact_onset.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/statistics.hpp"

namespace percuss::metrics {
namespace {

constexpr double kMinRiseLevel = 4;     // level at which the rise begins, in standard deviations of the noise
constexpr double kMaxRiseLevel = 0.25;  // level at which the fitted rise ends, over the first extreme
constexpr double kClearExtreme = 0.2;   // of the largest sample
constexpr double kFloor = 1e-3;         // of the first extreme: misfit of (1)
// An anti-alias filter rings before the touch: up to this many samples before the rise may have the opposite sign.
constexpr std::size_t kFilterRinging = 8;
constexpr double kSmear_samples = 0.5;  // by which such a filter may shift the start of the rise
constexpr double kMinPower = 0.5, kMaxPower = 2.5;
constexpr int kPowers = 9, kTimes = 48, kPasses = 4;
// Standard deviations of b and d of (1) before the samples are known. A half-sine has b = 0 and d = −0.01; responses
// of several modes have larger ones.
const Eigen::Vector2d kCurvature{0.3, 0.2};
constexpr double kNegligible = 20;  // in the logarithm of a probability

// The first extreme that is larger than the filter's ringing. The search ends where the signal falls to half of this
// extreme: noise alone does not fall so far.
std::size_t first_extreme(std::span<const double> x, std::size_t first) {
  const double largest = extremes_of(x).max_distance_from(0);
  std::size_t top = std::min(first, x.size() - 1);
  for (std::size_t i = top; i < x.size(); ++i) {
    if (std::abs(x[i]) > std::abs(x[top])) top = i;
    if (std::abs(x[top]) >= kClearExtreme * largest && std::abs(x[i]) < std::abs(x[top]) / 2) break;
  }
  return top;
}

// The samples of a rise, and the probability of a time and a power of (1).
class Rise {
 public:
  Rise(std::span<const double> x, std::size_t from, double noise)
      : x_(Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())) / noise),
        from_(static_cast<double>(from)) {}

  // The logarithm, but for a constant; c, b and d are integrated over.
  double log_probability(double onset, double power) const {
    const Eigen::Index n = x_.size();
    const double end = from_ + static_cast<double>(n - 1) - onset;
    Eigen::MatrixX3d shapes = Eigen::MatrixX3d::Zero(n, 3);
    for (Eigen::Index i = 0; i < n; ++i) {
      const double t = from_ + static_cast<double>(i) - onset;
      if (t <= 0) continue;
      const double part = t / end, rise = std::pow(t / end, power);
      shapes.row(i) << rise, rise * part, rise * part * part;
    }
    const double size = std::abs(x_[n - 1]);
    Eigen::Matrix3d normal = shapes.transpose() * shapes;
    normal.diagonal().tail<2>() += (kCurvature * size).cwiseAbs2().cwiseInverse();
    const Eigen::LLT<Eigen::Matrix3d> solver(normal);
    const Eigen::Vector3d right = shapes.transpose() * x_;
    const double misfit = x_.squaredNorm() - right.dot(solver.solve(right));
    return -misfit / 2 - solver.matrixLLT().diagonal().array().log().sum();
  }

 private:
  Eigen::VectorXd x_;
  double from_;
};

struct Onset {
  double sample = 0, std = 0;
};

// The mean and standard deviation of the time over all powers. The times are searched again more finely where they are
// probable.
Onset mean_onset(const Rise& rise, double least, double most) {
  Onset out;
  for (int pass = 0; pass < kPasses; ++pass) {
    Eigen::ArrayXXd logs(kTimes, kPowers);
    const double step = (most - least) / kTimes;
    const auto time = [&](int k) { return least + step * (k + 0.5); };
    for (int k = 0; k < kTimes; ++k) {
      for (int p = 0; p < kPowers; ++p)
        logs(k, p) = rise.log_probability(time(k), kMinPower + (kMaxPower - kMinPower) * p / (kPowers - 1));
    }
    const Eigen::ArrayXd weights = (logs - logs.maxCoeff()).exp().rowwise().sum();
    const Eigen::ArrayXd times = Eigen::ArrayXd::LinSpaced(kTimes, time(0), time(kTimes - 1));
    out.sample = (weights * times).sum() / weights.sum();
    out.std = std::sqrt((weights * (times - out.sample).square()).sum() / weights.sum() + step * step / 12);
    const Eigen::ArrayXd best = logs.rowwise().maxCoeff() - logs.maxCoeff();
    int lowest = 0, highest = kTimes - 1;
    while (lowest < highest && best[lowest] < -kNegligible) ++lowest;
    while (highest > lowest && best[highest] < -kNegligible) --highest;
    most = std::min(most, time(highest) + step);
    least = std::max(least, time(lowest) - step);
  }
  return out;
}

}  // namespace

ImpactOnset impact_onset(std::span<const double> x, double fs_Hz, std::size_t first, double noise) {
  const double between = 1 / std::sqrt(12.0);
  const std::size_t top = first_extreme(x, first);
  const double extreme = std::abs(x[top]), sign = std::copysign(1.0, x[top]);
  const double least = std::max(kMinRiseLevel * noise, kMinRiseLevel * kFloor * extreme);
  // The rise begins after the last sample within the noise that precedes the extreme.
  std::size_t from = top;
  while (from > 0 && sign * x[from - 1] > least) --from;
  const auto at = static_cast<double>(from);
  double other_side = 0;
  for (std::size_t i = from - std::min(from, kFilterRinging); i < from; ++i)
    other_side = std::max(other_side, -sign * x[i]);
  const bool rings = other_side > std::max(kMinRiseLevel * noise, kFloor * extreme);
  const double smear = rings ? kSmear_samples : 0;
  const std::size_t quiet = from - std::min(from, top - from + 1);
  std::size_t to = from;
  while (to < top && std::abs(x[to]) <= kMaxRiseLevel * extreme) ++to;
  if (to == from) return {.time_s = (at - 0.5) / fs_Hz, .std_s = std::hypot(between, smear) / fs_Hz};
  const double misfit = std::max(kFloor * extreme, rings ? other_side / 2 : 0.0);
  const Onset onset =
      mean_onset(Rise(x.subspan(quiet, to - quiet), quiet, std::hypot(noise, misfit)), static_cast<double>(quiet), at);
  return {.time_s = onset.sample / fs_Hz, .std_s = std::hypot(onset.std, smear) / fs_Hz};
}

}  // namespace percuss::metrics
