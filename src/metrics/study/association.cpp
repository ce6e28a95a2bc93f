#include "metrics/study/association.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/math/roots.hpp"
#include "core/math/statistics.hpp"
#include "metrics/protocol/averages.hpp"
#include "metrics/study/rank_permutations.hpp"

namespace percuss::metrics {
namespace {

constexpr double kNormal95 = 1.959963984540054;
constexpr double kTail = 0.025;
constexpr double kFarOut = 3.5;
constexpr std::size_t kMinForOutliers = 6;

// 2 · rank − (size + 1); ties share the mean of their ranks.
std::vector<int> centred_ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<int> ranks(values.size());
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && values[order[end]] == values[order[begin]]) ++end;
    for (std::size_t i = begin; i < end; ++i)
      ranks[order[i]] = static_cast<int>(begin + end) - static_cast<int>(values.size());
    begin = end;
  }
  return ranks;
}

struct Products {
  double xx = 0, xy = 0, yy = 0;
  void add(const std::vector<double>& x, const std::vector<double>& y) {
    const double mx = mean_of(x), my = mean_of(y);
    for (std::size_t i = 0; i < x.size(); ++i) {
      xx += (x[i] - mx) * (x[i] - mx);
      xy += (x[i] - mx) * (y[i] - my);
      yy += (y[i] - my) * (y[i] - my);
    }
  }
  double coefficient() const { return std::clamp(xy / std::sqrt(xx * yy), -1.0, 1.0); }
};

constexpr double kAlmostOne = 1 - 1e-15;  // artanh is infinite at 1

// (P15) of r
Correlation pearson_interval(double value, double freedom) {
  const double middle = std::atanh(std::clamp(value, -kAlmostOne, kAlmostOne)),
               half = kNormal95 / std::sqrt(freedom - 1);
  return {.value = value,
          .low = std::min(value, std::tanh(middle - half)),
          .high = std::max(value, std::tanh(middle + half))};
}

// The mean of the pooled rank correlation of bats whose x and y are normal with correlation sin(angle).
class MeanRankCorrelation {
 public:
  explicit MeanRankCorrelation(const std::vector<RankedClass>& classes) {
    double all = 0;
    for (const RankedClass& one : classes) {
      const double weight = std::sqrt(one.x_squares() * one.y_squares()), size = static_cast<double>(one.x.size()) + 1;
      by_rho_ += weight * (size - 3) / size;
      by_tau_ += weight * 3 / size;
      all += weight;
    }
    by_rho_ /= all;
    by_tau_ /= all;
  }

  /// The ρ of the population for which the mean rank correlation of a sample is `value`.
  double population(double value) const {
    if (std::abs(value) >= kAlmostOne) return value;
    const auto excess = [&](double angle) { return by_rho_ * rho_of(angle) + by_tau_ * tau_of(angle) - value; };
    return rho_of(bracketed_root(excess, -std::numbers::pi / 2, std::numbers::pi / 2));
  }

 private:
  static double rho_of(double angle) { return 6 / std::numbers::pi * std::asin(std::sin(angle) / 2); }
  static double tau_of(double angle) { return 2 / std::numbers::pi * angle; }
  double by_rho_ = 0, by_tau_ = 0;
};

// (P15) of ρ
Correlation spearman_interval(const std::vector<RankedClass>& classes, double value, double squares, double freedom) {
  // A swap of neighbours in the largest class changes the product least.
  std::size_t largest = 2;
  for (const RankedClass& one : classes) largest = std::max(largest, one.x.size());
  const double size = static_cast<double>(largest) + 1, limit = 1 - 0.5 / (size * size * squares);
  const double rho = std::clamp(value, -limit, limit), middle = std::atanh(rho);
  const double half = gsl_cdf_tdist_Pinv(0.975, freedom) * std::sqrt((1 + rho * rho / 2) / (freedom - 1));
  const double low = std::tanh(middle - half), high = std::tanh(middle + half);
  const MeanRankCorrelation mean(classes);
  Correlation out{
      .value = value, .low = std::min(low, mean.population(low)), .high = std::max(high, mean.population(high))};
  if (value > limit) out.high = 1;
  if (value < -limit) out.low = -1;
  return out;
}

// The largest c for which n ranks in random order have at most c inversions with a probability of at most 2.5 %.
// Nothing if P(no inversion) is above 2.5 %.
std::optional<std::size_t> rare_inversions(std::size_t n) {
  std::vector<double> probability{1};
  for (std::size_t k = 2; k <= n; ++k) {
    std::vector<double> next(probability.size() + k - 1, 0);
    for (std::size_t i = 0; i < probability.size(); ++i) {
      for (std::size_t added = 0; added < k; ++added) next[i + added] += probability[i] / static_cast<double>(k);
    }
    probability = std::move(next);
  }
  double sum = 0;
  std::optional<std::size_t> out;
  for (std::size_t c = 0; c < probability.size(); ++c) {
    sum += probability[c];
    if (sum > kTail) break;
    out = c;
  }
  return out;
}

}  // namespace

std::optional<Association> association_of(const std::vector<ClassPoints>& classes) {
  Association out;
  Products values;
  std::vector<RankedClass> ranked;
  double xx = 0, xy = 0, yy = 0;
  for (const ClassPoints& one : classes) {
    if (one.x.size() < 2) continue;
    out.points += one.x.size();
    ++out.classes;
    values.add(one.x, one.y);
    ranked.push_back({.x = centred_ranks(one.x), .y = centred_ranks(one.y)});
    xx += ranked.back().x_squares();
    xy += ranked.back().product();
    yy += ranked.back().y_squares();
  }
  const double d = static_cast<double>(out.points) - static_cast<double>(out.classes) - 1;
  if (!(d >= 2) || !(values.xx * values.yy > 0) || !(xx * yy > 0)) return std::nullopt;
  // Permutations do not change the product of a class without variation in x or y.
  std::erase_if(ranked, [](const RankedClass& one) { return !(one.x_squares() * one.y_squares() > 0); });
  if (ranked.empty()) return std::nullopt;
  const double rho = std::clamp(xy / std::sqrt(xx * yy), -1.0, 1.0);
  out.spearman = spearman_interval(ranked, rho, std::sqrt(xx * yy), d);
  out.pearson = pearson_interval(values.coefficient(), d);
  constexpr double kOnALine = 1 - 1e-12;
  if (std::abs(out.pearson.value) > kOnALine) {
    // Such points are rounded or computed. They lack the normal scatter that the interval assumes.
    out.pearson.low = std::min(out.pearson.low, out.spearman.low);
    out.pearson.high = std::max(out.pearson.high, out.spearman.high);
  }
  out.p = permutation_p(ranked);  // (P16)
  return out;
}

std::optional<TrendLine> trend_line_of(const ClassPoints& points) {
  std::vector<double> slopes;
  const std::size_t n = points.x.size();
  slopes.reserve(n * (n - std::min<std::size_t>(n, 1)) / 2);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (points.x[i] != points.x[k]) slopes.push_back((points.y[i] - points.y[k]) / (points.x[i] - points.x[k]));
    }
  }
  std::vector<double> distinct = points.x;
  std::sort(distinct.begin(), distinct.end());
  const auto different = static_cast<std::size_t>(std::unique(distinct.begin(), distinct.end()) - distinct.begin());
  if (different < 3) return std::nullopt;
  std::sort(slopes.begin(), slopes.end());
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  TrendLine line{.slope = median(slopes), .slope_low = -kInfinity, .slope_high = kInfinity};
  if (n <= kMaxPermutedBats) {  // (P17)
    if (const auto c = rare_inversions(different)) {
      line.slope_low = slopes[*c];
      line.slope_high = slopes[slopes.size() - 1 - *c];
    }
  } else {
    const auto count = static_cast<double>(slopes.size()), size = static_cast<double>(n);
    const double half = kNormal95 * std::sqrt(size * (size - 1) * (2 * size + 5) / 18);  // (P17)
    const auto slope_at = [&](double place) {
      return slopes[static_cast<std::size_t>(std::clamp(std::round(place), 0.0, count - 1))];
    };
    line.slope_low = slope_at((count - half) / 2 - 1);
    line.slope_high = slope_at((count + half) / 2);
  }
  std::vector<double> heights;
  heights.reserve(n);
  for (std::size_t i = 0; i < n; ++i) heights.push_back(points.y[i] - line.slope * points.x[i]);
  line.at = median(std::move(heights));
  return line;
}

std::vector<std::size_t> outliers_of(const ClassPoints& points, const TrendLine& line) {
  std::vector<std::size_t> out;
  if (points.x.size() < kMinForOutliers) return out;
  std::vector<double> residuals;
  residuals.reserve(points.x.size());
  for (std::size_t i = 0; i < points.x.size(); ++i)
    residuals.push_back(points.y[i] - line.at - line.slope * points.x[i]);
  const double spread = robust_std(residuals);
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (spread > 0 && std::abs(residuals[i]) > kFarOut * spread) out.push_back(i);  // (P18)
  }
  return out;
}

std::vector<double> holm_adjusted(const std::vector<double>& p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> out(p.size());
  double least = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    least = std::max(least, std::min(1.0, static_cast<double>(p.size() - k) * p[order[k]]));
    out[order[k]] = least;
  }
  return out;
}

}  // namespace percuss::metrics
