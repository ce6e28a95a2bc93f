#include "metrics/study/association.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math/statistics.hpp"
#include "metrics/protocol/averages.hpp"

namespace percuss::metrics {
namespace {

constexpr double kNormal95 = 1.959963984540054;
constexpr double kFarOut = 3.5;
constexpr std::size_t kMinForOutliers = 6;

// Ranks divided by size plus one: classes of different sizes have equal weight. Ties share the mean of their ranks.
std::vector<double> relative_ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  const double size = static_cast<double>(values.size()) + 1;
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && values[order[end]] == values[order[begin]]) ++end;
    for (std::size_t i = begin; i < end; ++i) ranks[order[i]] = 0.5 * static_cast<double>(begin + end + 1) / size;
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

// (P15)
Correlation with_interval(double value, double spread) {
  constexpr double kAlmostOne = 1 - 1e-15;  // largest argument with a finite artanh
  const double middle = std::atanh(std::clamp(value, -kAlmostOne, kAlmostOne));
  return {.value = value,
          .low = std::min(value, std::tanh(middle - kNormal95 * spread)),
          .high = std::max(value, std::tanh(middle + kNormal95 * spread))};
}

}  // namespace

std::optional<Association> association_of(const std::vector<ClassPoints>& classes) {
  Association out;
  Products values, ranks;
  for (const ClassPoints& one : classes) {
    if (one.x.size() < 2) continue;
    out.points += one.x.size();
    ++out.classes;
    values.add(one.x, one.y);
    ranks.add(relative_ranks(one.x), relative_ranks(one.y));
  }
  const double d = static_cast<double>(out.points) - static_cast<double>(out.classes) - 1;
  if (!(d >= 2) || !(values.xx * values.yy > 0) || !(ranks.xx * ranks.yy > 0)) return std::nullopt;
  const double rho = ranks.coefficient();
  out.pearson = with_interval(values.coefficient(), 1 / std::sqrt(d - 1));
  out.spearman = with_interval(rho, std::sqrt((1 + rho * rho / 2) / (d - 1)));
  const double t = std::abs(rho) * std::sqrt(d / std::max(1 - rho * rho, 1e-300));
  out.p = std::min(1.0, 2 * gsl_cdf_tdist_Q(t, d));  // (P16)
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
  if (std::unique(distinct.begin(), distinct.end()) - distinct.begin() < 3) return std::nullopt;
  std::sort(slopes.begin(), slopes.end());
  const auto count = static_cast<double>(slopes.size()), size = static_cast<double>(n);
  const double half = kNormal95 * std::sqrt(size * (size - 1) * (2 * size + 5) / 18);  // (P17)
  const auto slope_at = [&](double place) {
    return slopes[static_cast<std::size_t>(std::clamp(std::round(place), 0.0, count - 1))];
  };
  TrendLine line{.slope = median(slopes),
                 .slope_low = slope_at((count - half) / 2 - 1),
                 .slope_high = slope_at((count + half) / 2)};
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
