#include "identify/shapes/scan_scatter.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/significance.hpp"

namespace percuss::identify {
namespace {

constexpr int kPasses = 20;                // of the weights; they settle within a few
constexpr double kFirstPosition_m = 2e-3;  // σ_x and σ_g of the first weights
constexpr double kFirstRelative = 0.02;
constexpr double kRoundingNoise = 1e-9;  // of the largest amplitude: lower limit of a hit's noise

double largest_amplitude(const ScanShape& shape) {
  double largest = 0;
  for (const double amplitude : shape.amplitude) largest = std::max(largest, std::abs(amplitude));
  return largest;
}

// Slope of the parabola through a point and its neighbours, at the point.
double slope_at(const ScanShape& shape, std::size_t point) {
  const std::size_t n = shape.position_m.size();
  if (n < 2) return 0;
  const auto secant = [&](std::size_t a, std::size_t b) {
    return (shape.amplitude[b] - shape.amplitude[a]) / (shape.position_m[b] - shape.position_m[a]);
  };
  if (n == 2) return secant(0, 1);
  const std::size_t middle = std::clamp<std::size_t>(point, 1, n - 2);
  const double below = secant(middle - 1, middle), above = secant(middle, middle + 1);
  const double x = shape.position_m[point];
  const double lower = shape.position_m[middle - 1], centre = shape.position_m[middle];
  const double bend = (above - below) / (shape.position_m[middle + 1] - lower);
  return below + bend * (2 * x - lower - centre);
}

double noise2_of(const AmplitudeOfHit& hit, double largest) {
  return std::pow(std::max(hit.std, kRoundingNoise * largest), 2);
}

// The variance of the hits of one point for one mode.
struct PointVariance {
  double noise2 = 0;             // of one hit, mean over the hits
  double slope2 = 0, size2 = 0;  // φ′², φ²
  double variance = 0;           // of one hit about the mean of the point
  double degrees = 0;
};

std::vector<PointVariance> variances_of(const HitsAlongScan& mode) {
  const double largest = largest_amplitude(mode.shape);
  std::vector<PointVariance> out;
  for (std::size_t p = 0; p < mode.hits.size(); ++p) {
    const auto& hits = mode.hits[p];
    if (hits.size() < 2) continue;
    const auto count = static_cast<double>(hits.size());
    double mean = 0;
    for (const AmplitudeOfHit& hit : hits) mean += hit.value / count;
    PointVariance one{.slope2 = std::pow(slope_at(mode.shape, p), 2),
                      .size2 = std::pow(mode.shape.amplitude[p], 2),
                      .degrees = count - 1};
    for (const AmplitudeOfHit& hit : hits) {
      one.noise2 += noise2_of(hit, largest) / count;
      one.variance += std::pow(hit.value - mean, 2) / (count - 1);
    }
    out.push_back(one);
  }
  return out;
}

struct Variances {
  double position2 = 0, relative2 = 0;
};

// a and b of y ≈ a u + b v, neither negative, by weighted least squares.
class TwoVariances {
 public:
  void add(double u, double v, double y, double weight) {
    uu_ += weight * u * u;
    uv_ += weight * u * v;
    vv_ += weight * v * v;
    uy_ += weight * u * y;
    vy_ += weight * v * y;
  }
  Variances solve() const {
    const double determinant = uu_ * vv_ - uv_ * uv_;
    if (determinant > 0) {
      const double a = (vv_ * uy_ - uv_ * vy_) / determinant, b = (uu_ * vy_ - uv_ * uy_) / determinant;
      if (a >= 0 && b >= 0) return {a, b};
    }
    const double a = uu_ > 0 ? std::max(0.0, uy_ / uu_) : 0, b = vv_ > 0 ? std::max(0.0, vy_ / vv_) : 0;
    return a * uy_ >= b * vy_ ? Variances{a, 0} : Variances{0, b};  // the one that explains more
  }

 private:
  double uu_ = 0, uv_ = 0, vv_ = 0, uy_ = 0, vy_ = 0;
};

}  // namespace

std::optional<ScanScatter> scatter_along_scan(std::span<const HitsAlongScan> modes) {
  std::vector<PointVariance> all;
  double chi2 = 0, degrees = 0;
  double most_degrees = 0;  // of one mode
  for (const HitsAlongScan& mode : modes) {
    double degrees_of_mode = 0;
    for (const PointVariance& one : variances_of(mode)) {
      chi2 += one.degrees * one.variance / one.noise2;
      degrees_of_mode += one.degrees;
      all.push_back(one);
    }
    degrees += degrees_of_mode;
    most_degrees = std::max(most_degrees, degrees_of_mode);
  }
  if (!(degrees > 0) || !(chi2_deviate(chi2, degrees) > kOnceIn1000)) return std::nullopt;
  Variances found{std::pow(kFirstPosition_m, 2), std::pow(kFirstRelative, 2)};
  for (int pass = 0; pass < kPasses; ++pass) {
    TwoVariances fit;
    for (const PointVariance& one : all) {
      const double expected = one.noise2 + found.position2 * one.slope2 + found.relative2 * one.size2;
      fit.add(one.slope2, one.size2, one.variance - one.noise2, one.degrees / (expected * expected));
    }
    found = fit.solve();
  }
  return ScanScatter{.position_std_m = std::sqrt(found.position2),
                     .relative_std = std::sqrt(found.relative2),
                     .degrees_of_freedom = most_degrees};  // not their sum: the modes share their hits
}

ScanShape with_scatter(const HitsAlongScan& mode, const ScanScatter& scatter) {
  ScanShape shape = mode.shape;
  const double largest = largest_amplitude(shape), student = student_factor(scatter.degrees_of_freedom);
  for (std::size_t p = 0; p < mode.hits.size(); ++p) {
    double sum = 0, squares = 0, noise2 = 0;
    for (const AmplitudeOfHit& hit : mode.hits[p]) {
      sum += hit.power;
      squares += hit.power * hit.power;
      noise2 += hit.power * hit.power * noise2_of(hit, largest);
    }
    if (!(sum > 0)) continue;
    const double place =
        std::hypot(slope_at(shape, p) * scatter.position_std_m, shape.amplitude[p] * scatter.relative_std);
    shape.std[p] = std::hypot(std::sqrt(noise2) / sum, student * place * std::sqrt(squares) / sum);
  }
  return shape;
}

}  // namespace percuss::identify
