#include "identify/shapes/scan_scatter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/math/significance.hpp"
#include "core/math/statistics.hpp"

namespace percuss::identify {
namespace {

constexpr int kPasses = 20;                // of the weights; they settle within a few
constexpr double kFirstPosition_m = 2e-3;  // σ_x and σ_g of the first weights
constexpr double kFirstRelative = 0.02;
constexpr double kFarVariance = 4;  // factor of the scatter of other modes: the mode has a scatter of its own
constexpr int kGroupPasses = 5;
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

using VarianceTable = std::vector<std::vector<PointVariance>>;  // [modes][points with two hits or more]
using ModeSet = std::vector<std::size_t>;                       // ascending

double expected_variance(const PointVariance& one, const Variances& scatter) {
  return one.noise2 + scatter.position2 * one.slope2 + scatter.relative2 * one.size2;
}

Variances fitted_to(const VarianceTable& table, const ModeSet& modes) {
  Variances found{std::pow(kFirstPosition_m, 2), std::pow(kFirstRelative, 2)};
  for (int pass = 0; pass < kPasses; ++pass) {
    TwoVariances fit;
    for (const std::size_t m : modes) {
      for (const PointVariance& one : table[m]) {
        const double expected = expected_variance(one, found);
        fit.add(one.slope2, one.size2, one.variance - one.noise2, one.degrees / (expected * expected));
      }
    }
    found = fit.solve();
  }
  return found;
}

// χ²/ν of a typical point, over its value for Gaussian errors. The median does not feel a few wrong hits.
double typical_ratio(std::vector<double> of_points, double degrees_of_point) {
  const double median_of_chi2 = std::pow(1 - 2 / (9 * degrees_of_point), 3);  // Wilson and Hilferty
  return median(std::move(of_points)) / median_of_chi2;
}

double mean_degrees(const std::vector<PointVariance>& points) {
  double degrees = 0;
  for (const PointVariance& one : points) degrees += one.degrees;
  return degrees / static_cast<double>(points.size());
}

// Whether the points of a mode scatter far more or far less than `scatter` states. Noise that is stated too large does
// not count as less.
bool disagrees(const std::vector<PointVariance>& points, const Variances& scatter) {
  if (points.empty()) return false;
  std::vector<double> high, low;
  double chi2 = 0, chi2_low = 0, degrees = 0;
  for (const PointVariance& one : points) {
    const double expected = expected_variance(one, scatter);
    high.push_back(one.variance / expected);
    low.push_back(std::max(one.variance, one.noise2) / expected);
    chi2 += one.degrees * high.back();
    chi2_low += one.degrees * low.back();
    degrees += one.degrees;
  }
  const double of_point = mean_degrees(points);
  const bool more =
      typical_ratio(std::move(high), of_point) > kFarVariance && chi2_deviate(chi2, degrees) > kOnceIn1000;
  return more ||
         (typical_ratio(std::move(low), of_point) < 1 / kFarVariance && chi2_deviate(chi2_low, degrees) < -kOnceIn1000);
}

ModeSet agreeing(const VarianceTable& table, const Variances& scatter) {
  ModeSet modes;
  for (std::size_t m = 0; m < table.size(); ++m) {
    if (!disagrees(table[m], scatter)) modes.push_back(m);
  }
  return modes;
}

struct CommonScatter {
  ModeSet modes;
  Variances scatter;
};

// The modes that agree with one scatter. All of them if none disagrees; otherwise the largest set that grows from the
// scatter of one mode, with the least scatter of equally large ones.
CommonScatter common_scatter(const VarianceTable& table) {
  ModeSet all(table.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  CommonScatter best{.modes = all, .scatter = fitted_to(table, all)};
  if (agreeing(table, best.scatter) == all) return best;
  best.modes.clear();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t seed = 0; seed < table.size(); ++seed) {
    if (table[seed].empty()) continue;
    CommonScatter grown{.modes = {seed}, .scatter = fitted_to(table, {seed})};
    for (int pass = 0; pass < kGroupPasses; ++pass) {
      ModeSet modes = agreeing(table, grown.scatter);
      if (modes.empty() || modes == grown.modes) break;
      grown.scatter = fitted_to(table, modes);
      grown.modes = std::move(modes);
    }
    double size = 0;
    for (const auto& points : table) {
      for (const PointVariance& one : points) size += one.degrees * std::log(expected_variance(one, grown.scatter));
    }
    if (grown.modes.size() < best.modes.size() || (grown.modes.size() == best.modes.size() && !(size < least)))
      continue;
    best = std::move(grown);
    least = size;
  }
  return best;
}

ScanScatter scatter_from(const VarianceTable& table, const ModeSet& modes, const Variances& found) {
  double most_degrees = 0;  // not their sum: the modes share their hits
  for (const std::size_t m : modes) {
    double degrees = 0;
    for (const PointVariance& one : table[m]) degrees += one.degrees;
    most_degrees = std::max(most_degrees, degrees);
  }
  return ScanScatter{.position_std_m = std::sqrt(found.position2),
                     .relative_std = std::sqrt(found.relative2),
                     .degrees_of_freedom = most_degrees};
}

// The scatter of a hit at a typical point over the rms amplitude.
double part_of_amplitude(const std::vector<PointVariance>& points) {
  if (points.empty()) return 0;
  std::vector<double> variance;
  double size2 = 0;
  for (const PointVariance& one : points) {
    variance.push_back(std::max(0.0, one.variance - one.noise2));
    size2 += one.size2 / static_cast<double>(points.size());
  }
  return size2 > 0 ? std::sqrt(typical_ratio(std::move(variance), mean_degrees(points)) / size2) : 0;
}

}  // namespace

std::vector<ScanScatter> scatter_along_scan(std::span<const HitsAlongScan> modes) {
  VarianceTable table;
  double chi2 = 0, degrees = 0;
  for (const HitsAlongScan& mode : modes) {
    table.push_back(variances_of(mode));
    for (const PointVariance& one : table.back()) {
      chi2 += one.degrees * one.variance / one.noise2;
      degrees += one.degrees;
    }
  }
  if (!(degrees > 0) || !(chi2_deviate(chi2, degrees) > kOnceIn1000)) return {};
  const CommonScatter common = common_scatter(table);
  std::vector<ScanScatter> out;
  for (std::size_t m = 0; m < table.size(); ++m) {
    const bool shared = std::binary_search(common.modes.begin(), common.modes.end(), m) || table[m].empty();
    out.push_back(shared ? scatter_from(table, common.modes, common.scatter)
                         : scatter_from(table, {m}, fitted_to(table, {m})));
    out.back().of_amplitude = part_of_amplitude(table[m]);
  }
  return out;
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
