#pragma once
#include <cstddef>
#include <optional>
#include <vector>

namespace percuss::metrics {

/// Bats of one class: a property x and a performance y. shapes: x and y of the same length.
struct ClassPoints {
  std::vector<double> x, y;
};

/// A correlation coefficient and its 95 % interval.
struct Correlation {
  double value = 0, low = 0, high = 0;
};

/// The association of x and y within classes.
struct Association {
  std::size_t points = 0, classes = 0;  // without classes of one point, which contribute nothing
  Correlation pearson, spearman;
  double p = 1;  // two-sided probability of a Spearman correlation at least as strong, without association
};

/// Correlation within classes, without the differences between classes. r correlates values minus their class's mean. ρ
/// correlates ranks within the class, divided by its size plus one, minus their mean (midranks for ties). For one class
/// they are the usual r and ρ. With d = points − classes − 1 degrees of freedom
///   r:  tanh(artanh r ± 1.96/√(d − 1)); for points on a straight line within rounding, widened to include the
///       interval of ρ
///   ρ:  E⁻¹(tanh(artanh ρ ± t √((1 + ρ²/2)/(d − 1)))), t Student's 97.5 % quantile of d degrees of freedom,
///       E(ρ) = Σ w_c [(n_c − 2) ρ + 3τ]/(n_c + 1): the mean of the coefficient if x and y are normal with the rank
///       correlation ρ and Kendall's τ. Class c has n_c bats; w_c is its share of Σ_c √(Σx² Σy²) of the ranks. E⁻¹
///       only widens the interval.                                                                  (P15)
///   p: permutation_p of the ranks                                                                  (P16)
/// For its interval, a ρ of ±1 is moved towards zero by half the change that a swap of two neighbours makes.
/// None below d = 2, or when x or y does not vary within classes.
/// source  [3], [16] and [22] in docs/theory/sources.md
std::optional<Association> association_of(const std::vector<ClassPoints>& classes);

/// A robust straight line y = at + slope x, and the 95 % interval of its slope.
struct TrendLine {
  double slope = 0, at = 0, slope_low = 0, slope_high = 0;  // infinite ends: unbounded
};

/// The Theil–Sen line: the median of the slopes of all pairs of points, and the median of y − slope x. The interval
/// ends at these ranks of the N sorted slopes:
///   up to 12 points: c + 1 and N − c. c is the largest number such that a random order of as many ranks as there are
///   different x has at most c inversions with a probability of at most 2.5 %; unbounded where there is no such c
///   else (N − q)/2 and (N + q)/2 + 1, q = 1.96 √(n(n−1)(2n+5)/18)                                   (P17)
/// The line withstands outliers up to 29 % of the points. None for fewer than 3 different values of x.
/// source  [17]
std::optional<TrendLine> trend_line_of(const ClassPoints& points);

/// The points further from the line than 3.5 robust standard deviations of the residuals, (P18); none for fewer than 6
/// points.
std::vector<std::size_t> outliers_of(const ClassPoints& points, const TrendLine& line);

/// Adjusts the probabilities of several tests: the chance of any false positive stays at the level of a single test.
/// The k-th smallest of m is multiplied by m − k + 1, and none is below its predecessor (Holm, [18]).      (P19)
std::vector<double> holm_adjusted(const std::vector<double>& p);

}  // namespace percuss::metrics
