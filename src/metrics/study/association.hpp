#pragma once
#include <cstddef>
#include <optional>
#include <vector>

namespace percuss::metrics {

/// Bats of one class, by a property x and a performance y. shapes: x and y alike long.
struct ClassPoints {
  std::vector<double> x, y;
};

/// A correlation coefficient and its 95 % interval.
struct Correlation {
  double value = 0, low = 0, high = 0;
};

/// How x and y go together within classes.
struct Association {
  std::size_t points = 0, classes = 0;  // those that tell something: classes of one point do not
  Correlation pearson, spearman;
  double p = 1;  // of as strong a Spearman correlation or a stronger one, either way, where there is none
};

/// Correlation within classes, with what the classes differ by taken off: r is that of values less their class's mean,
/// ρ that of ranks within the class over its size plus one, less their mean (midranks for ties); for one class the
/// usual r and ρ. With d = points − classes − 1 degrees of freedom
///   interval:  tanh(artanh r ± 1.96/√(d − 1)),  tanh(artanh ρ ± 1.96 √((1 + ρ²/2)/(d − 1)))           (P15)
///   p: Student's t of d degrees, t = ρ √(d/(1 − ρ²))                                                (P16)
/// Nothing below d = 2, or when x or y does not vary within classes. Sources [3] and [16] in docs/theory/sources.md.
std::optional<Association> association_of(const std::vector<ClassPoints>& classes);

/// A straight line y = at + slope x through the bulk of the points, and the slope's 95 % interval.
struct TrendLine {
  double slope = 0, at = 0, slope_low = 0, slope_high = 0;
};

/// The median of the slopes between all two points, and the median of y − slope x; the interval counts slopes:
///   the (N ∓ 1.96 √(n(n−1)(2n+5)/18))/2-th of N in order                                          (P17)
/// Theil and Sen's line; up to 29 % of the points may lie anywhere. Nothing for fewer than 3 values of x. [17]
std::optional<TrendLine> trend_line_of(const ClassPoints& points);

/// Which points lie further from the line than 3.5 times the residuals' robust standard deviation, (P18); none of
/// fewer than 6.
std::vector<std::size_t> outliers_of(const ClassPoints& points, const TrendLine& line);

/// Probabilities of several tests, each raised so that the chance of any false positive stays what it is for one alone:
/// the k-th smallest of m times m − k + 1, and none below the one before (Holm, [18]).                (P19)
std::vector<double> holm_adjusted(const std::vector<double>& p);

}  // namespace percuss::metrics
