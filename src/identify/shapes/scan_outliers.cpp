#include "identify/shapes/scan_outliers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "core/math/statistics.hpp"
#include "identify/shapes/scan_curves.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kMinDeviations = 12;
constexpr double kPartOfHits = 0.5;   // hits with this part of kMinDeviations do not fit either
constexpr double kMinRelative = 0.1;  // of the largest amplitude near the point
constexpr double kSameShape = 0.9;    // MAC
constexpr std::size_t kWindowPoints = 13;
constexpr double kMedianToStd = 1.4826;  // of |x| for Gaussian errors
constexpr double kNearPlace = 0.25;      // largest deviation at a position that fits, over that at the stated position

// The modes along the scan: the amplitudes of the points, and their standard deviations from the noise.
struct ScanTable {
  std::vector<double> position_m;
  MatrixXd value, std;                           // [points, modes]
  std::vector<std::vector<std::size_t>> shapes;  // modes of one shape
};

// The noise of the mean over the hits; the standard deviation of the point where its hits are not known.
double noise_of_point(const HitsAlongScan& mode, std::size_t point) {
  if (point >= mode.hits.size() || mode.hits[point].empty()) return mode.shape.std[point];
  double sum = 0, noise2 = 0;
  for (const AmplitudeOfHit& hit : mode.hits[point]) {
    sum += hit.power;
    noise2 += std::pow(hit.power * hit.std, 2);
  }
  return sum > 0 ? std::sqrt(noise2) / sum : mode.shape.std[point];
}

std::vector<std::vector<std::size_t>> distinct_shapes(const MatrixXd& value) {
  std::vector<std::vector<std::size_t>> shapes;
  for (Index m = 0; m < value.cols(); ++m) {
    const auto alike = std::find_if(shapes.begin(), shapes.end(), [&](const std::vector<std::size_t>& shape) {
      const auto first = value.col(static_cast<Index>(shape.front()));
      const double product = first.dot(value.col(m));
      return product * product > kSameShape * first.squaredNorm() * value.col(m).squaredNorm();
    });
    std::vector<std::size_t>& shape = alike == shapes.end() ? shapes.emplace_back() : *alike;
    shape.push_back(static_cast<std::size_t>(m));
  }
  return shapes;
}

ScanTable scan_table(std::span<const HitsAlongScan> modes) {
  ScanTable table{.position_m = modes.front().shape.position_m, .value = {}, .std = {}, .shapes = {}};
  const auto points = static_cast<Index>(table.position_m.size()), count = static_cast<Index>(modes.size());
  table.value.resize(points, count);
  table.std.resize(points, count);
  for (Index m = 0; m < count; ++m) {
    const HitsAlongScan& mode = modes[static_cast<std::size_t>(m)];
    for (Index p = 0; p < points; ++p) {
      table.value(p, m) = mode.shape.amplitude[static_cast<std::size_t>(p)];
      table.std(p, m) = noise_of_point(mode, static_cast<std::size_t>(p));
    }
  }
  table.shapes = distinct_shapes(table.value);
  return table;
}

// The nearest points, ascending.
std::vector<std::size_t> window_around(const std::vector<double>& position_m, std::size_t point) {
  std::vector<std::size_t> nearest(position_m.size());
  std::iota(nearest.begin(), nearest.end(), std::size_t{0});
  const auto far = [&](std::size_t i) { return std::abs(position_m[i] - position_m[point]); };
  std::stable_sort(nearest.begin(), nearest.end(), [&](std::size_t a, std::size_t b) { return far(a) < far(b); });
  nearest.resize(std::min(nearest.size(), kWindowPoints));
  std::sort(nearest.begin(), nearest.end());
  return nearest;
}

// The prediction of a point from the other points of the window, without `other` if it is given.
std::optional<PredictedPoint> predicted_without(const ScanTable& table, const std::vector<std::size_t>& window,
                                                const VectorXd& largest, std::size_t point,
                                                std::optional<std::size_t> other) {
  std::vector<std::size_t> kept;
  for (const std::size_t p : window) {
    if (p != point && p != other) kept.push_back(p);
  }
  if (kept.size() < kMinCurvePoints) return std::nullopt;
  const double low = table.position_m[window.front()], high = table.position_m[window.back()];
  const auto place = [&](std::size_t p) { return (2 * table.position_m[p] - low - high) / (high - low); };
  VectorXd u(static_cast<Index>(kept.size()));
  MatrixXd y(u.size(), table.value.cols());
  for (Index i = 0; i < u.size(); ++i) {
    const std::size_t p = kept[static_cast<std::size_t>(i)];
    u(i) = place(p);
    y.row(i) = table.value.row(static_cast<Index>(p)).cwiseQuotient(largest.transpose());
  }
  return predict_point(u, y, place(point));
}

struct PointAgainstCurves {
  VectorXd largest;  // near the point, [modes]: the unit of the prediction
  PredictedPoint predicted;
};

// For each mode, the typical variance of one hit about the mean of its point, over the window; 0 if each point has one
// hit. It comes from a median, because a few wrong hits hardly change it.
VectorXd variance_of_hits(std::span<const HitsAlongScan> modes, const std::vector<std::size_t>& window,
                          const VectorXd& largest) {
  VectorXd variance = VectorXd::Zero(largest.size());
  for (std::size_t m = 0; m < modes.size(); ++m) {
    std::vector<double> off;
    for (const std::size_t p : window) {
      if (p >= modes[m].hits.size() || modes[m].hits[p].size() < 2) continue;
      const auto& hits = modes[m].hits[p];
      const auto count = static_cast<double>(hits.size());
      double mean = 0;
      for (const AmplitudeOfHit& hit : hits) mean += hit.value / count;
      for (const AmplitudeOfHit& hit : hits) off.push_back(std::abs(hit.value - mean) * std::sqrt(count / (count - 1)));
    }
    if (off.empty()) continue;
    const auto at = static_cast<Index>(m);
    variance(at) = std::pow(kMedianToStd * median(off) / largest(at), 2);
  }
  return variance;
}

std::optional<PointAgainstCurves> against_curves(std::span<const HitsAlongScan> modes, const ScanTable& table,
                                                 std::size_t point) {
  const std::vector<std::size_t> window = window_around(table.position_m, point);
  VectorXd largest = VectorXd::Zero(table.value.cols());
  for (const std::size_t p : window)
    largest = largest.cwiseMax(table.value.row(static_cast<Index>(p)).transpose().cwiseAbs());
  if (!(largest.minCoeff() > 0)) return std::nullopt;
  auto best = predicted_without(table, window, largest, point, std::nullopt);
  if (!best) return std::nullopt;
  double limit = best->cost - 2 * std::log(2.0) * static_cast<double>(largest.size());
  for (const std::size_t other : window) {
    if (other == point) continue;
    auto without = predicted_without(table, window, largest, point, other);
    if (!without || without->cost >= limit) continue;
    limit = without->cost;
    best = std::move(without);
  }
  std::size_t hits = 1;
  for (const HitsAlongScan& mode : modes)
    hits = point < mode.hits.size() ? std::max(hits, mode.hits[point].size()) : hits;
  best->point_variance = best->point_variance.cwiseMax(
      variance_of_hits(modes, window, largest).cwiseProduct(best->local) / static_cast<double>(hits));
  return PointAgainstCurves{.largest = std::move(largest), .predicted = std::move(*best)};
}

// The second largest deviation over the distinct shapes. A mode without a value does not count.
double deviations_of(const ScanTable& table, const PointAgainstCurves& at,
                     const std::vector<std::optional<double>>& value, const std::vector<double>& std, double hits) {
  std::vector<double> of_shapes;
  for (const std::vector<std::size_t>& shape : table.shapes) {
    double most = 0;
    for (const std::size_t mode : shape) {
      if (!value[mode]) continue;
      const auto m = static_cast<Index>(mode);
      const double off = std::abs(*value[mode] / at.largest(m) - at.predicted.value(m));
      if (off < kMinRelative) continue;
      const double noise = std[mode] / at.largest(m);
      most = std::max(most, off / std::sqrt(hits * at.predicted.point_variance(m) + at.predicted.curve_variance(m) +
                                            noise * noise));
    }
    of_shapes.push_back(most);
  }
  std::sort(of_shapes.rbegin(), of_shapes.rend());
  return of_shapes.size() < 2 ? 0 : of_shapes[1];
}

// The amplitudes of one hit, [modes].
struct HitAmplitudes {
  std::vector<std::optional<double>> value;
  std::vector<double> std;
};

std::map<std::size_t, HitAmplitudes> hits_of_point(std::span<const HitsAlongScan> modes, std::size_t point) {
  std::map<std::size_t, HitAmplitudes> hits;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (point >= modes[m].hits.size()) continue;
    for (const AmplitudeOfHit& hit : modes[m].hits[point]) {
      HitAmplitudes& one = hits[hit.hit];
      one.value.resize(modes.size());
      one.std.resize(modes.size());
      one.value[m] = hit.value;
      one.std[m] = hit.std;
    }
  }
  return hits;
}

std::optional<ScanOutlier> outlier_at(std::span<const HitsAlongScan> modes, const ScanTable& table, std::size_t point) {
  const auto at = against_curves(modes, table, point);
  if (!at) return std::nullopt;
  std::vector<std::optional<double>> mean;
  std::vector<double> std;
  for (Index m = 0; m < table.value.cols(); ++m) {
    mean.emplace_back(table.value(static_cast<Index>(point), m));
    std.push_back(table.std(static_cast<Index>(point), m));
  }
  ScanOutlier out{.point = point, .hits = {}, .deviations = deviations_of(table, *at, mean, std, 1), .fits_m = {}};
  const auto hits = hits_of_point(modes, point);
  if (hits.size() > 1) {
    for (const auto& [hit, amplitudes] : hits) {
      const double deviations =
          deviations_of(table, *at, amplitudes.value, amplitudes.std, static_cast<double>(hits.size()));
      out.deviations = std::max(out.deviations, deviations);
      if (deviations > kPartOfHits * kMinDeviations) out.hits.push_back(hit);
    }
  }
  if (!(out.deviations > kMinDeviations)) return std::nullopt;
  if (out.hits.size() == hits.size()) out.hits.clear();
  return out;
}

// The position on the straight lines between the points that fit, at which the amplitudes are nearest to `value`,
// [modes], in units of the largest ones.
std::optional<double> fitting_position_m(const ScanTable& table, const std::vector<ScanOutlier>& outliers,
                                         const VectorXd& value, std::size_t point) {
  const VectorXd scale = table.value.cwiseAbs().colwise().maxCoeff().transpose().cwiseInverse();
  std::vector<std::size_t> good;
  for (std::size_t p = 0; p < table.position_m.size(); ++p) {
    if (std::none_of(outliers.begin(), outliers.end(), [&](const ScanOutlier& one) { return one.point == p; }))
      good.push_back(p);
  }
  const auto amplitudes = [&](std::size_t p) -> VectorXd {
    return table.value.row(static_cast<Index>(p)).transpose().cwiseProduct(scale);
  };
  const VectorXd wanted = value.cwiseProduct(scale);
  double least = std::numeric_limits<double>::infinity(), here = least, best_m = 0;
  for (std::size_t i = 0; i + 1 < good.size(); ++i) {
    const VectorXd low = amplitudes(good[i]), step = amplitudes(good[i + 1]) - low;
    const double low_m = table.position_m[good[i]], step_m = table.position_m[good[i + 1]] - low_m;
    const auto distance = [&](double part) { return (low + part * step - wanted).norm(); };
    const double part = std::clamp(step.dot(wanted - low) / std::max(step.squaredNorm(), 1e-300), 0.0, 1.0);
    if (distance(part) < least) {
      least = distance(part);
      best_m = low_m + part * step_m;
    }
    const double stated = (table.position_m[point] - low_m) / step_m;
    if (stated >= 0 && stated <= 1) here = distance(stated);
  }
  if (!std::isfinite(here)) here = (amplitudes(point < good.front() ? good.front() : good.back()) - wanted).norm();
  return least < kNearPlace * here ? std::optional(best_m) : std::nullopt;
}

// The mean over the hits that do not fit.
VectorXd amplitudes_of_outlier(std::span<const HitsAlongScan> modes, const ScanTable& table,
                               const ScanOutlier& outlier) {
  VectorXd value = table.value.row(static_cast<Index>(outlier.point)).transpose();
  if (outlier.hits.empty()) return value;
  for (Index m = 0; m < value.size(); ++m) {
    double sum = 0, count = 0;
    for (const AmplitudeOfHit& hit : modes[static_cast<std::size_t>(m)].hits[outlier.point]) {
      if (!std::binary_search(outlier.hits.begin(), outlier.hits.end(), hit.hit)) continue;
      sum += hit.value;
      ++count;
    }
    if (count > 0) value(m) = sum / count;
  }
  return value;
}

}  // namespace

std::vector<ScanOutlier> scan_outliers(std::span<const HitsAlongScan> modes) {
  if (modes.empty()) return {};
  const std::vector<double>& position_m = modes.front().shape.position_m;
  const bool alike = std::all_of(modes.begin(), modes.end(),
                                 [&](const HitsAlongScan& mode) { return mode.shape.position_m == position_m; });
  if (!alike || position_m.size() < kMinCurvePoints + 1) return {};
  const ScanTable table = scan_table(modes);
  if (table.shapes.size() < 2) return {};
  std::vector<ScanOutlier> outliers;
  for (std::size_t point = 0; point < position_m.size(); ++point) {
    if (auto one = outlier_at(modes, table, point)) outliers.push_back(std::move(*one));
  }
  for (ScanOutlier& one : outliers)
    one.fits_m = fitting_position_m(table, outliers, amplitudes_of_outlier(modes, table, one), one.point);
  return outliers;
}

}  // namespace percuss::identify
