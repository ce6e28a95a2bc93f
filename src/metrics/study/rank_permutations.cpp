#include "metrics/study/rank_permutations.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <numeric>
#include <set>

namespace percuss::metrics {
namespace {

constexpr std::size_t kGrid = 8192;      // grid values of a convolution of classes of different sizes
constexpr double kProductSlack = 1e-10;  // of a product, for rounding

double scale_of(std::size_t bats) {
  const double size = static_cast<double>(bats) + 1;
  return 1 / (4 * size * size);
}

double sum_of_products(const std::vector<int>& a, const std::vector<int>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<double>(a[i]) * b[i];
  return sum;
}

// Ranks as multiples of a common step above the least: rank = low + step · value.
struct Lattice {
  int low = 0, step = 1;
  std::vector<int> value;
};

Lattice lattice_of(const std::vector<int>& ranks) {
  Lattice out{.low = *std::min_element(ranks.begin(), ranks.end()), .step = 0};
  for (const int r : ranks) out.step = std::gcd(out.step, r - out.low);
  out.step = std::max(out.step, 1);
  for (const int r : ranks) out.value.push_back((r - out.low) / out.step);
  return out;
}

// A distribution on base + unit · index.
struct LatticeDistribution {
  double base = 0, unit = 1;
  std::vector<double> probability;
};

// The distribution of Σ x_i y_π(i) for lattice values. A state is how many values of each group of equal y are used
// already, written as the digits of one number. Each x_i uses one more value, and so leads to states of larger numbers.
std::vector<double> product_distribution(std::vector<int> x, const std::vector<int>& y) {
  std::map<int, std::size_t> groups;
  for (const int v : y) ++groups[v];
  struct Group {
    int value = 0;
    std::size_t size = 0, place = 1;
  };
  std::vector<Group> group;
  std::size_t states = 1;
  for (const auto& [value, size] : groups) {
    group.push_back({value, size, states});
    states *= size + 1;
  }
  std::sort(x.begin(), x.end());
  std::vector<int> sorted_y = y;
  std::sort(sorted_y.begin(), sorted_y.end());
  const auto largest = static_cast<std::size_t>(std::inner_product(x.begin(), x.end(), sorted_y.begin(), 0));
  std::vector<std::vector<double>> at(states);
  at[0].assign(largest + 1, 0);
  at[0][0] = 1;
  for (std::size_t state = 0; state + 1 < states; ++state) {
    const std::vector<double> here = std::move(at[state]);
    at[state].clear();
    std::size_t row = 0;
    for (const Group& g : group) row += state / g.place % (g.size + 1);
    for (const Group& g : group) {
      const std::size_t left = g.size - state / g.place % (g.size + 1);
      if (left == 0) continue;
      std::vector<double>& next = at[state + g.place];
      next.resize(largest + 1, 0);
      const double weight = static_cast<double>(left) / static_cast<double>(y.size() - row);
      const auto shift = static_cast<std::size_t>(x[row] * g.value);
      for (std::size_t k = 0; k + shift <= largest; ++k) next[k + shift] += weight * here[k];
    }
  }
  return std::move(at.back());
}

// The same for the ranks of n bats without ties, computed once.
const std::vector<double>& untied_distribution(std::size_t n) {
  static std::array<std::once_flag, kMaxPermutedBats + 1> once;
  static std::array<std::vector<double>, kMaxPermutedBats + 1> known;
  std::call_once(once.at(n), [n] {
    std::vector<int> ranks(n);
    std::iota(ranks.begin(), ranks.end(), 0);
    known.at(n) = product_distribution(ranks, ranks);
  });
  return known.at(n);
}

bool untied(const Lattice& ranks) {
  return ranks.value.size() == std::set(ranks.value.begin(), ranks.value.end()).size();
}

LatticeDistribution distribution_of(const RankedClass& one) {
  const Lattice x = lattice_of(one.x), y = lattice_of(one.y);
  const double scale = scale_of(one.x.size()), n = static_cast<double>(one.x.size());
  // Σ (lx + sx x)(ly + sy y) with Σ of all ranks zero: = −n lx ly + sx sy Σ x y.
  return {.base = -scale * n * x.low * y.low,
          .unit = scale * x.step * y.step,
          .probability =
              untied(x) && untied(y) ? untied_distribution(one.x.size()) : product_distribution(x.value, y.value)};
}

// The distribution on a coarser or finer unit: values move by at most half of it.
LatticeDistribution on_unit(const LatticeDistribution& d, double unit) {
  const auto at = [&](std::size_t i) {
    return static_cast<std::size_t>(std::llround(static_cast<double>(i) * d.unit / unit));
  };
  LatticeDistribution out{.base = d.base, .unit = unit};
  out.probability.assign(at(d.probability.size() - 1) + 1, 0);
  for (std::size_t i = 0; i < d.probability.size(); ++i) out.probability[at(i)] += d.probability[i];
  return out;
}

void convolve(LatticeDistribution& a, const LatticeDistribution& b) {
  std::vector<double> sum(a.probability.size() + b.probability.size() - 1, 0);
  for (std::size_t k = 0; k < b.probability.size(); ++k) {
    if (b.probability[k] == 0) continue;
    for (std::size_t i = 0; i < a.probability.size(); ++i) sum[i + k] += a.probability[i] * b.probability[k];
  }
  a.probability = std::move(sum);
  a.base += b.base;
}

double exact_p(const std::vector<RankedClass>& classes, double product) {
  std::vector<LatticeDistribution> all;
  double span = 0;
  for (const RankedClass& one : classes) {
    all.push_back(distribution_of(one));
    span += all.back().unit * static_cast<double>(all.back().probability.size() - 1);
  }
  const bool alike = std::all_of(all.begin(), all.end(), [&](const auto& d) { return d.unit == all[0].unit; });
  const double unit = alike ? all[0].unit : span / kGrid, moved = alike ? 0 : unit / 2;
  LatticeDistribution total = alike ? all[0] : on_unit(all[0], unit);
  for (std::size_t i = 1; i < all.size(); ++i) convolve(total, alike ? all[i] : on_unit(all[i], unit));
  const double least = std::abs(product) - moved * static_cast<double>(all.size()) - kProductSlack;
  double p = 0;
  for (std::size_t i = 0; i < total.probability.size(); ++i) {
    if (std::abs(total.base + unit * static_cast<double>(i)) >= least) p += total.probability[i];
  }
  return p;
}

// k₄/k₂² of Fisher's k-statistics.
double excess_of(const std::vector<int>& ranks) {
  const double n = static_cast<double>(ranks.size());
  double s2 = 0, s4 = 0;
  for (const int r : ranks) {
    const double square = static_cast<double>(r) * r;
    s2 += square;
    s4 += square * square;
  }
  const double k2 = s2 / (n - 1);
  const double k4 = n * ((n + 1) * s4 - 3 * (n - 1) / n * s2 * s2) / ((n - 1) * (n - 2) * (n - 3));
  return k4 / (k2 * k2);
}

double beta_p(const std::vector<RankedClass>& classes, double product) {
  double variance = 0, fourth = 0;  // cumulants
  for (const RankedClass& one : classes) {
    const double n = static_cast<double>(one.x.size()), squares = one.x_squares() * one.y_squares();
    double r4 = 3 / ((n - 1) * (n + 1));
    if (n > 3) r4 += excess_of(one.x) * excess_of(one.y) * (n - 2) * (n - 3) / (n * (n + 1) * std::pow(n - 1, 3));
    variance += squares / (n - 1);
    fourth += squares * squares * (r4 - 3 / ((n - 1) * (n - 1)));
  }
  const double excess = fourth / (variance * variance);
  constexpr double kAlmostNormal = -1e-9;
  if (excess > kAlmostNormal) return std::erfc(std::abs(product) / std::sqrt(2 * variance));
  // A beta distribution (shape, shape) on ± half: excess −6/(2 shape + 3), variance half²/(2 shape + 1).
  const double shape = (-6 / excess - 3) / 2, half_squared = variance * (2 * shape + 1);
  return gsl_cdf_beta_Q(std::min(1.0, product * product / half_squared), 0.5, shape);
}

}  // namespace

double RankedClass::product() const { return scale_of(x.size()) * sum_of_products(x, y); }
double RankedClass::x_squares() const { return scale_of(x.size()) * sum_of_products(x, x); }
double RankedClass::y_squares() const { return scale_of(y.size()) * sum_of_products(y, y); }

double permutation_p(const std::vector<RankedClass>& classes) {
  double product = 0, log_orders = 0;
  bool small = true;
  for (const RankedClass& one : classes) {
    product += one.product();
    log_orders += std::lgamma(static_cast<double>(one.x.size()) + 1);
    small = small && one.x.size() <= kMaxPermutedBats;
  }
  const double p = small ? exact_p(classes, product) : beta_p(classes, product);
  return std::clamp(p, std::exp(-log_orders), 1.0);
}

}  // namespace percuss::metrics
