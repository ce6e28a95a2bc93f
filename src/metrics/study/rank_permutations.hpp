#pragma once
#include <cstddef>
#include <vector>

namespace percuss::metrics {

/// The bats of one class, ranked: 2 · rank − (bats + 1), with midranks for ties. The ranks are integers around zero.
struct RankedClass {
  std::vector<int> x, y;

  /// Σxy/(4 (bats + 1)²): the product of ranks relative to bats + 1, so that classes of all sizes count alike.
  double product() const;
  double x_squares() const;  // Σx²/(4 (bats + 1)²)
  double y_squares() const;
};

/// Classes of at most this many bats are permuted exactly.
inline constexpr std::size_t kMaxPermutedBats = 12;

/// The probability of a product at least as far from zero as the product of `classes`, if all permutations of y within
/// each class are equally probable (two-sided, ties included).
///   exact where every class has at most kMaxPermutedBats: the distribution of each class by recursion over its bats,
///   and their convolution. Classes of different sizes are convolved on a grid of 8192 values; rounding raises the
///   probability by at most the probability of a few grid values.
///   else a symmetric beta distribution with the second and fourth moment of all permutations (Pitman). Far from
///   zero it is too large: for 13 bats by 4 % at 0.01, by a factor of 2 at 1e-4.                               (P16)
/// It is never below the probability of a single permutation.
/// source  [22] in docs/theory/sources.md
double permutation_p(const std::vector<RankedClass>& classes);

}  // namespace percuss::metrics
