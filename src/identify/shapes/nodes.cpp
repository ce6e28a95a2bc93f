#include "identify/shapes/nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "core/math/linear_algebra.hpp"
#include "core/math/roots.hpp"
#include "core/math/significance.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kNodeCertain = 3;       // standard deviations from zero of a significant sign
constexpr double kMinNodeNoise = 1e-12;  // of the largest amplitude: lower limit of a standard deviation

// A polynomial of one degree fitted to the points near a crossing.
struct PolynomialFit {
  VectorXd coefficient;  // ascending powers of u = (x − middle)/scale
  MatrixXd covariance;   // with the stated standard deviations
  double chi2 = 0;
  std::size_t degrees_of_freedom = 0;
  std::optional<double> root_u;  // the root within the bracket

  double at(double u) const {
    double value = 0;
    for (Index i = coefficient.size(); i-- > 0;) value = value * u + coefficient(i);
    return value;
  }
  double slope(double u) const {
    double value = 0;
    for (Index i = coefficient.size(); i-- > 1;) value = value * u + static_cast<double>(i) * coefficient(i);
    return value;
  }
  double scale2() const {
    return degrees_of_freedom == 0 ? 1 : std::max(1.0, chi2 / static_cast<double>(degrees_of_freedom));
  }
  double root_std(double scale2) const {
    VectorXd power(coefficient.size());
    for (Index i = 0; i < power.size(); ++i) power(i) = std::pow(*root_u, static_cast<double>(i));
    return std::sqrt(power.dot(covariance * power) * scale2) / std::abs(slope(*root_u));
  }
};

std::optional<double> root_within(const PolynomialFit& fit, double low, double high) {
  if (!(fit.at(low) * fit.at(high) < 0)) return std::nullopt;
  return bracketed_root([&](double u) { return fit.at(u); }, low, high);
}

PolynomialFit fit_polynomial(const VectorXd& u, const VectorXd& y, const VectorXd& std, int degree) {
  MatrixXd columns(u.size(), degree + 1);
  VectorXd power = std.cwiseInverse();
  for (Index i = 0; i <= degree; ++i, power = power.cwiseProduct(u)) columns.col(i) = power;
  const VectorXd scaled = y.cwiseQuotient(std);
  PolynomialFit fit;
  fit.covariance = inverse_gram(MatrixXd(columns.transpose() * columns));
  fit.coefficient = least_squares(columns, scaled);
  fit.chi2 = (scaled - columns * fit.coefficient).squaredNorm();
  fit.degrees_of_freedom = static_cast<std::size_t>(std::max<Index>(0, u.size() - degree - 1));
  return fit;
}

// The data of one crossing; positions in units of half the window's width.
struct Window {
  VectorXd u, y, std;
  double middle_m = 0, scale_m = 1;
  double low_u = 0, high_u = 0;  // the bracket
};

Window crossing_window(const ScanShape& shape, std::size_t below, std::size_t above, std::size_t most) {
  const double middle = 0.5 * (shape.position_m[below] + shape.position_m[above]);
  std::vector<std::size_t> order(shape.position_m.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto far = [&](std::size_t i) { return std::abs(shape.position_m[i] - middle); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return far(a) < far(b); });
  order.resize(std::min(order.size(), std::max(most, above - below + 1)));
  Window w{.u = VectorXd(static_cast<Index>(order.size())),
           .y = VectorXd(static_cast<Index>(order.size())),
           .std = VectorXd(static_cast<Index>(order.size())),
           .middle_m = middle,
           .scale_m = far(order.back())};
  double largest = 0;
  for (const double a : shape.amplitude) largest = std::max(largest, std::abs(a));
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto at = static_cast<Index>(i);
    w.u(at) = (shape.position_m[order[i]] - middle) / w.scale_m;
    w.y(at) = shape.amplitude[order[i]];
    w.std(at) = std::max(shape.std[order[i]], kMinNodeNoise * largest);
  }
  w.low_u = (shape.position_m[below] - middle) / w.scale_m;
  w.high_u = (shape.position_m[above] - middle) / w.scale_m;
  return w;
}

// Polynomials of every degree through the nearest points of a window, for every number of points.
class LocalFits {
 public:
  LocalFits(const Window& window, std::size_t fewest, int highest_degree)
      : fewest_(fewest), all_(static_cast<std::size_t>(window.u.size())), highest_(highest_degree) {
    for (std::size_t points = fewest_; points <= all_; ++points) {
      const auto n = static_cast<Index>(points);
      for (int degree = 1; degree <= highest_ + 1 && static_cast<std::size_t>(degree) < points; ++degree) {
        PolynomialFit fit = fit_polynomial(window.u.head(n), window.y.head(n), window.std.head(n), degree);
        fit.root_u = root_within(fit, window.low_u, window.high_u);
        fits_.emplace(std::pair{points, degree}, std::move(fit));
      }
    }
  }

  std::size_t fewest() const { return fewest_; }
  std::size_t points() const { return all_; }
  int highest_degree(std::size_t points) const { return std::min(highest_, static_cast<int>(points) - 1); }
  const PolynomialFit& at(std::size_t points, int degree) const { return fits_.at({points, degree}); }
  // The fit if it exists and crosses zero within the bracket.
  const PolynomialFit* crossing(std::size_t points, int degree) const {
    const auto found = fits_.find({points, degree});
    return found != fits_.end() && found->second.root_u ? &found->second : nullptr;
  }

 private:
  std::size_t fewest_ = 0, all_ = 0;
  int highest_ = 0;  // of a node; one degree more shows the model error
  std::map<std::pair<std::size_t, int>, PolynomialFit> fits_;
};

// The scatter of the points beyond their standard deviations.
struct LocalScatter {
  double variance = 1;  // factor of the stated variances
  double student = 1;   // factor of standard deviations, where `variance` is estimated from few points
};

// The scatter from χ² per degree of freedom of the highest-degree fit. The window grows from the crossing until the
// next point contradicts the polynomial. That point does not count: it shows that the shape departs from the
// polynomial, not that the points scatter more.
LocalScatter local_scatter(const LocalFits& fits) {
  constexpr std::size_t kMinDegreesOfFreedom = 3;
  constexpr double kContradicts = 2.6;  // normal deviates: once in 100 cases
  LocalScatter out;
  const PolynomialFit* last = nullptr;
  const std::size_t most = fits.at(fits.points(), fits.highest_degree(fits.points())).degrees_of_freedom;
  const std::size_t least = std::clamp<std::size_t>(most, 1, kMinDegreesOfFreedom);
  for (std::size_t points = fits.fewest(); points <= fits.points(); ++points) {
    const PolynomialFit& fit = fits.at(points, fits.highest_degree(points));
    if (fit.degrees_of_freedom < least) continue;
    if (last != nullptr) {
      const double limit = student_quantile(kContradicts, static_cast<double>(last->degrees_of_freedom));
      if (fit.chi2 - last->chi2 > limit * limit * out.variance) break;
    }
    out.variance = std::max(out.variance, fit.scale2());
    last = &fit;
  }
  if (last != nullptr) {
    const auto degrees = static_cast<double>(last->degrees_of_freedom);
    if (chi2_deviate(last->chi2, degrees) > kOnceIn1000) out.student = student_factor(degrees);
  }
  return out;
}

struct ChosenFit {
  std::size_t points = 0;
  int degree = 0;
};

// The fit with the least χ²/s² + p ln n. Each point that a fit leaves out counts as a coefficient.
std::optional<ChosenFit> choose_fit(const LocalFits& fits, double variance) {
  const double cost = std::log(static_cast<double>(fits.points()));
  std::optional<ChosenFit> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t points = fits.fewest(); points <= fits.points(); ++points) {
    for (int degree = 1; degree <= fits.highest_degree(points); ++degree) {
      const PolynomialFit* fit = fits.crossing(points, degree);
      if (fit == nullptr) continue;
      const double score =
          fit->chi2 / variance + (static_cast<double>(degree) + static_cast<double>(fits.points() - points)) * cost;
      if (score < least) {
        best = ChosenFit{.points = points, .degree = degree};
        least = score;
      }
    }
  }
  return best;
}

// The larger of two distances to the chosen root: of the root of the next higher degree (else of the next lower one),
// and of the root with two points less (else with one less). Nothing where none of them has a root.
std::optional<double> model_error_u(const LocalFits& fits, const ChosenFit& chosen) {
  const double root_u = *fits.at(chosen.points, chosen.degree).root_u;
  const PolynomialFit* degree = fits.crossing(chosen.points, chosen.degree + 1);
  if (degree == nullptr) degree = fits.crossing(chosen.points, chosen.degree - 1);
  const PolynomialFit* support = nullptr;
  for (std::size_t less = 2; less > 0 && support == nullptr; --less)
    support = fits.crossing(chosen.points - less, chosen.degree);
  std::optional<double> out;
  for (const PolynomialFit* other : {degree, support}) {
    if (other != nullptr) out = std::max(out.value_or(0), std::abs(*other->root_u - root_u));
  }
  return out;
}

Node node_between(const ScanShape& shape, std::size_t below, std::size_t above, const NodeOptions& options) {
  constexpr std::size_t kFewestPoints = 4;
  const Window w = crossing_window(shape, below, above, options.points);
  const auto points = static_cast<std::size_t>(w.u.size());
  const LocalFits fits(w, std::max(std::min(kFewestPoints, points), above - below + 1), options.highest_degree);
  const LocalScatter scatter = local_scatter(fits);
  const auto chosen = choose_fit(fits, scatter.variance);
  // No polynomial crosses zero between the two points: the node is only known to lie between them.
  const double width_m = (w.high_u - w.low_u) * w.scale_m;
  if (!chosen) return {.position_m = w.middle_m, .std_m = width_m / std::sqrt(12.0), .points = points};
  const PolynomialFit& fit = fits.at(chosen->points, chosen->degree);
  const auto error_u = model_error_u(fits, *chosen);
  const double model_m = error_u ? *error_u * w.scale_m : width_m / std::sqrt(12.0);
  // The shape may contain a term of the next degree that is not significant. The root's standard deviation is therefore
  // the standard deviation of the next degree's fit.
  const PolynomialFit* higher = fits.crossing(chosen->points, chosen->degree + 1);
  const PolynomialFit& wider = higher != nullptr ? *higher : fit;
  const double fit_m = wider.root_std(std::max(scatter.variance, wider.scale2())) * w.scale_m * scatter.student;
  return {.position_m = w.middle_m + *fit.root_u * w.scale_m,
          .std_m = std::hypot(fit_m, model_m),
          .degree = chosen->degree,
          .points = chosen->points};
}

}  // namespace

std::vector<Node> find_nodes(const ScanShape& shape, const NodeOptions& options) {
  std::vector<Node> nodes;
  std::optional<std::size_t> last;  // the last point with a significant sign
  for (std::size_t i = 0; i < shape.amplitude.size(); ++i) {
    if (!(std::abs(shape.amplitude[i]) > kNodeCertain * shape.std[i])) continue;
    if (last && shape.amplitude[*last] * shape.amplitude[i] < 0)
      nodes.push_back(node_between(shape, *last, i, options));
    last = i;
  }
  return nodes;
}

std::string_view name_of(NoNode reason) {
  switch (reason) {
    case NoNode::few_positions:
      return "few_positions";
    case NoNode::varies:
      return "varies";
    case NoNode::uncertain:
      return "uncertain";
    case NoNode::same_sign:
      return "same_sign";
    case NoNode::wide:
      return "wide";
  }
  return "";
}

void drop_wide_nodes(std::vector<Node>& nodes, const ScanShape& shape) {
  if (nodes.empty()) return;
  const double anywhere_m = (shape.position_m.back() - shape.position_m.front()) / std::sqrt(12.0);
  std::erase_if(nodes, [&](const Node& node) { return !(node.std_m < anywhere_m); });
}

NoNode reason_without_node(const ScanShape& shape) {
  std::size_t positive = 0, negative = 0;
  for (std::size_t i = 0; i < shape.amplitude.size(); ++i) {
    if (!(std::abs(shape.amplitude[i]) > kNodeCertain * shape.std[i])) continue;
    ++(shape.amplitude[i] > 0 ? positive : negative);
  }
  if (positive > 0 && negative > 0) return NoNode::wide;
  return positive + negative < 2 ? NoNode::uncertain : NoNode::same_sign;
}

std::optional<double> minimum_of_peak(std::span<const double> position_m, std::span<const double> peak,
                                      double resolution_m) {
  constexpr double kMaxLowest = 0.5;  // of the largest peak: near a node, the lowest peak is smaller
  const std::size_t n = peak.size();
  if (n < 3) return std::nullopt;
  const auto low = static_cast<std::size_t>(std::min_element(peak.begin(), peak.end()) - peak.begin());
  if (peak[low] > kMaxLowest * *std::max_element(peak.begin(), peak.end())) return std::nullopt;
  std::size_t next = 0;
  if (low == 0 || low + 1 == n) {
    next = low == 0 ? 1 : n - 2;
    const std::size_t after = low == 0 ? 2 : n - 3;
    // One side of the V rises from `next` to `after`. The other side has the same slope. If the bottom lies outside the
    // two lowest points, all three points are on one side.
    const double steep = (peak[after] - peak[next]) / std::abs(position_m[after] - position_m[next]) *
                         std::abs(position_m[next] - position_m[low]);
    if (std::abs(peak[low] + peak[next] - steep) >= std::abs(peak[next] - peak[low] - steep)) return std::nullopt;
  } else {
    next = peak[low - 1] < peak[low + 1] ? low - 1 : low + 1;
  }
  const double sum = peak[low] + peak[next];
  const double part = sum > 0 ? peak[low] / sum : 0;
  const double bottom_m = position_m[low] + part * (position_m[next] - position_m[low]);
  return std::round(bottom_m / resolution_m) * resolution_m;
}

}  // namespace percuss::identify
