#include "identify/shapes/circumferential_fit.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/math/linear_algebra.hpp"

namespace percuss::identify {
namespace {

constexpr double kSameRing = 2e-3;           // axial distance of neighbours in a ring, over the survey's length
constexpr double kSameAngle = 0.01;          // rad between two equal angles
constexpr std::size_t kMinRingAngles = 4;    // distinguish n = 1 from n = 2
constexpr int kMaxCircumferentialOrder = 8;  // n
constexpr double kMaxGap_rad = 2.6;          // 149°: rings with a wider gap are arcs
constexpr double kResolved = 0.05;           // least ratio of a pattern's smallest pivot to its largest

struct Point {
  double position_m = 0, angle_rad = 0, value = 0, std = 0;
};

// The real shape at the points with a known place, ascending along the axis.
std::vector<Point> placed(const ModeShape& shape, const TubeGeometry& geometry) {
  const Complex turn = turn_of(shape.places);
  std::vector<Point> points;
  const ShapePlace* last = nullptr;
  for (const ShapePlace& place : shape.places) {
    const auto at = geometry.find(place.point);
    if (at == geometry.end() || (last != nullptr && last->point == place.point)) continue;
    last = &place;
    points.push_back({at->second.position_m, at->second.angle_rad, (place.value * turn).real(), place.std});
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const Point& a, const Point& b) { return a.position_m < b.position_m; });
  return points;
}

using Ring = std::vector<Point>;

std::size_t distinct_angles(const Ring& ring) {
  std::vector<double> seen;
  for (const Point& p : ring) {
    const bool known = std::any_of(seen.begin(), seen.end(), [&](double a) {
      return std::abs(std::remainder(a - p.angle_rad, 2 * std::numbers::pi)) < kSameAngle;
    });
    if (!known) seen.push_back(p.angle_rad);
  }
  return seen.size();
}

std::vector<Ring> rings_of(const std::vector<Point>& points) {
  std::vector<Ring> rings;
  if (points.empty()) return rings;
  const double gap = kSameRing * (points.back().position_m - points.front().position_m);
  for (const Point& p : points) {
    if (rings.empty() || p.position_m - rings.back().back().position_m > gap) rings.emplace_back();
    rings.back().push_back(p);
  }
  std::erase_if(rings, [](const Ring& ring) { return distinct_angles(ring) < kMinRingAngles; });
  return rings;
}

Eigen::MatrixXd patterns(const Ring& ring, int highest) {
  Eigen::MatrixXd out(static_cast<Eigen::Index>(ring.size()), Eigen::Index{2} * highest + 1);
  for (Eigen::Index i = 0; i < out.rows(); ++i) {
    const double angle_rad = ring[static_cast<std::size_t>(i)].angle_rad;
    out(i, 0) = 1;
    for (Eigen::Index n = 1; n <= highest; ++n) {
      out(i, 2 * n - 1) = std::cos(static_cast<double>(n) * angle_rad);
      out(i, 2 * n) = std::sin(static_cast<double>(n) * angle_rad);
    }
  }
  return out;
}

// At 2n evenly spaced angles, only one combination of cos nθ and sin nθ is observable. Returns its coefficients.
Eigen::Vector2d observable_combination(const Ring& ring, int n) {
  std::complex<double> sum;
  for (const Point& p : ring) sum += std::polar(1.0, 2 * n * p.angle_rad);
  return {std::cos(0.5 * std::arg(sum)), std::sin(0.5 * std::arg(sum))};
}

// Fills pattern and inverse. False where the ring does not resolve the highest order.
bool fit_ring(const Ring& ring, int highest, bool half, CircumferentialFit& fit) {
  fit.pattern = patterns(ring, highest);
  fit.half = half;
  Eigen::MatrixXd columns = fit.pattern;
  const Eigen::Vector2d turn = half ? observable_combination(ring, highest) : Eigen::Vector2d(1, 0);
  if (half) {
    columns.conservativeResize(Eigen::NoChange, Eigen::Index{2} * highest);
    columns.rightCols<1>() = fit.pattern.rightCols<2>() * turn;
  }
  const auto inverse = left_inverse(columns, kResolved);
  if (!inverse) return false;
  fit.inverse = *inverse;
  if (!half) return true;
  const Eigen::RowVectorXd last = fit.inverse.bottomRows<1>();
  fit.inverse.conservativeResize(fit.pattern.cols(), Eigen::NoChange);
  fit.inverse.bottomRows<2>() = turn * last;
  return true;
}

// The highest order that every ring resolves; 0 where a ring's angles are too close together.
int fit_all(const std::vector<Ring>& rings, std::size_t angles, std::vector<CircumferentialFit>& fits) {
  for (int highest = std::min(kMaxCircumferentialOrder, static_cast<int>(angles) / 2); highest >= 1; --highest) {
    const bool half = 2 * highest == static_cast<int>(angles);
    fits.assign(rings.size(), {});
    bool all = true;
    for (std::size_t r = 0; r < rings.size() && all; ++r) all = fit_ring(rings[r], highest, half, fits[r]);
    if (all) return highest;
  }
  return 0;
}

// The gaps between neighbouring angles of a ring, ascending, around the whole circle.
std::vector<double> gaps_of(const Ring& ring) {
  std::vector<double> angles, gaps;
  for (const Point& p : ring) {
    const double turn = 2 * std::numbers::pi;
    angles.push_back(p.angle_rad - turn * std::floor(p.angle_rad / turn));
  }
  std::sort(angles.begin(), angles.end());
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double next = i + 1 < angles.size() ? angles[i + 1] : angles[0] + 2 * std::numbers::pi;
    if (next - angles[i] > kSameAngle) gaps.push_back(next - angles[i]);
  }
  std::sort(gaps.begin(), gaps.end());
  return gaps;
}

// The widest spacing within the arcs, over all rings; 0 where every ring covers the circle.
double arc_spacing_rad(const std::vector<Ring>& rings) {
  double spacing = 0;
  bool arc = false;
  for (const Ring& ring : rings) {
    const std::vector<double> gaps = gaps_of(ring);
    if (gaps.size() < 2) continue;
    arc = arc || gaps.back() > kMaxGap_rad;
    spacing = std::max(spacing, gaps[gaps.size() - 2]);
  }
  return arc ? spacing : 0;
}

// Each order's block is inverted alone. False where the arc does not resolve the cosine and the sine of an order.
bool fit_orders_alone(const Ring& ring, int highest, CircumferentialFit& fit) {
  fit.pattern = patterns(ring, highest);
  fit.inverse = Eigen::MatrixXd::Zero(fit.pattern.cols(), fit.pattern.rows());
  for (int n = 0; n <= highest; ++n) {
    const Eigen::Index first = n == 0 ? 0 : 2 * n - 1, count = n == 0 ? 1 : 2;
    const auto inverse = left_inverse(Eigen::MatrixXd(fit.pattern.middleCols(first, count)), kResolved);
    if (!inverse) return false;
    fit.inverse.middleRows(first, count) = *inverse;
  }
  return true;
}

// Fits the orders n whose half wave π/n is longer than the spacing, with a quarter order to spare:
// n ≤ π/spacing − kBelowHalfWave.
void fit_arcs(const std::vector<Ring>& rings, double spacing_rad, CircumferentialFits& out) {
  constexpr double kBelowHalfWave = 0.25;
  out.arc = true;
  out.angles = static_cast<std::size_t>(std::lround(2 * std::numbers::pi / spacing_rad));
  out.highest =
      std::min(kMaxCircumferentialOrder, static_cast<int>(std::floor(std::numbers::pi / spacing_rad - kBelowHalfWave)));
  out.rings.assign(rings.size(), {});
  bool all = out.highest > 0;
  for (std::size_t r = 0; r < rings.size() && all; ++r) all = fit_orders_alone(rings[r], out.highest, out.rings[r]);
  if (!all) out.highest = 0;
}

void fill(const Ring& ring, CircumferentialFit& fit) {
  const auto size = static_cast<Eigen::Index>(ring.size());
  fit.value.resize(size);
  fit.variance.resize(size);
  fit.position_m = 0;
  for (Eigen::Index i = 0; i < size; ++i) {
    const Point& p = ring[static_cast<std::size_t>(i)];
    fit.value(i) = p.value;
    fit.variance(i) = p.std * p.std;
    fit.position_m += p.position_m / static_cast<double>(size);
  }
}

}  // namespace

CircumferentialFits fit_circumferential(const ModeShape& shape, const TubeGeometry& geometry) {
  const auto rings = rings_of(placed(shape, geometry));
  CircumferentialFits out;
  if (rings.empty()) return out;
  out.angles = distinct_angles(rings.front());
  for (const Ring& ring : rings) out.angles = std::min(out.angles, distinct_angles(ring));
  const double spacing_rad = arc_spacing_rad(rings);
  if (spacing_rad > 0) {
    fit_arcs(rings, spacing_rad, out);
  } else {
    out.highest = fit_all(rings, out.angles, out.rings);
  }
  if (out.highest == 0) out.rings.clear();
  for (std::size_t r = 0; r < out.rings.size(); ++r) fill(rings[r], out.rings[r]);
  return out;
}

}  // namespace percuss::identify
