#include "identify/shapes/mac.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include "core/math/significance.hpp"

namespace percuss::identify {
namespace {

using Complex = std::complex<double>;

constexpr double kRoundingOfValue = 1e-9;  // of a value in one hit without noise

struct Products {
  Complex cross;          // aᴴb
  double aa = 0, bb = 0;  // aᴴa, bᴴb
};

Products products(const ShapeValues& a, const ShapeValues& b) {
  Products p;
  for (std::size_t i = 0; i < a.value.size(); ++i) {
    p.cross += std::conj(a.value[i]) * b.value[i];
    p.aa += std::norm(a.value[i]);
    p.bb += std::norm(b.value[i]);
  }
  return p;
}

// A change of the values changes the MAC by 2 Re(by_a δa + by_b δb).
struct Gradient {
  Complex by_a, by_b;
};

Gradient gradient(const ShapeValues& a, const ShapeValues& b, const Products& p, double value, std::size_t i) {
  return {.by_a = p.cross * std::conj(b.value[i]) / (p.aa * p.bb) - value * std::conj(a.value[i]) / p.aa,
          .by_b = std::conj(p.cross) * std::conj(a.value[i]) / (p.aa * p.bb) - value * std::conj(b.value[i]) / p.bb};
}

// First order: |∂MAC/∂b_i|² σ_i² for real and imaginary part, and likewise for a.
double first_order(const ShapeValues& a, const ShapeValues& b, const Products& p, double value, std::size_t i) {
  const Gradient g = gradient(a, b, p, value, i);
  return 4 * (std::norm(g.by_b) * b.std[i] * b.std[i] + std::norm(g.by_a) * a.std[i] * a.std[i]);
}

// Noise orthogonal to a shape lowers a MAC of 1 by its energy over the shape's energy.
double lost_to_noise(const ShapeValues& shape, double energy, std::size_t i) {
  return 2 * shape.std[i] * shape.std[i] * (1 - std::norm(shape.value[i]) / energy);
}

// Noise parallel to the other shape raises a MAC of 0, by this over the shapes' energies.
double gained_by_noise(const ShapeValues& a, const ShapeValues& b, std::size_t i) {
  return 2 * b.std[i] * b.std[i] * std::norm(a.value[i]) + 2 * a.std[i] * a.std[i] * std::norm(b.value[i]);
}

// The variance of a sum of independent parts. Parts that were estimated from few hits have degrees of freedom.
class VarianceSum {
 public:
  void add_known(double variance) { total_ += variance; }
  void add_estimated(double variance, double degrees) {
    total_ += variance;
    squares_ += variance * variance / (degrees + 2);
  }
  // With Student's factor for the degrees of freedom of the sum: Welch and Satterthwaite's, without the bias of the
  // squares of estimated variances. The factor is squared, as for the variance of an error.
  double variance() const { return total_ * factor() * factor(); }
  // The same for an error in proportion to the variance.
  double magnitude() const { return total_ * factor(); }

 private:
  double factor() const { return squares_ > 0 ? student_factor(total_ * total_ / squares_ - 2) : 1; }
  double total_ = 0, squares_ = 0;
};

// The parts of the error of a MAC: of the first order, and of the second order at MAC 1 (lost) and MAC 0 (gained).
struct MacError {
  Products products;
  VarianceSum first{}, lost_a{}, lost_b{}, lost_by_hits{}, gained{};  // lost_a, lost_b, gained: times the energies

  void add_place(const ShapeValues& a, const ShapeValues& b, double value, std::size_t i) {
    first.add_known(first_order(a, b, products, value, i));
    lost_a.add_known(lost_to_noise(a, products.aa, i));
    lost_b.add_known(lost_to_noise(b, products.bb, i));
    gained.add_known(gained_by_noise(a, b, i));
  }
  Mac mac(double value) const {
    const double lost =
        value * (lost_a.magnitude() / products.aa + lost_b.magnitude() / products.bb + lost_by_hits.magnitude());
    // The rise is exponentially distributed: its rms is √2 times its mean.
    const double rise = (1 - value) * (std::sqrt(2.0) * gained.magnitude() / (products.aa * products.bb));
    const double std = std::sqrt(first.variance() + lost * lost + rise * rise);
    return {.value = value, .std = std::min(std, std::max(value, 1 - value))};
  }
};

double value_of(const Products& p) { return std::min(1.0, std::norm(p.cross) / (p.aa * p.bb)); }  // (1)

// The common places of two shapes.
struct CommonPlaces {
  ShapeValues a, b;
  std::vector<std::size_t> of_a, of_b;                       // [common places] index into ModeShape::places
  std::map<std::size_t, std::vector<std::size_t>> of_point;  // common places
};

CommonPlaces common_places(const ModeShape& a, const ModeShape& b) {
  CommonPlaces out;
  for (std::size_t i = 0; i < a.places.size(); ++i) {
    const ShapePlace& place = a.places[i];
    const auto other = std::find_if(b.places.begin(), b.places.end(), [&](const ShapePlace& p) {
      return p.point == place.point && p.channel == place.channel;
    });
    if (other == b.places.end()) continue;
    out.of_point[place.point].push_back(out.of_a.size());
    out.of_a.push_back(i);
    out.of_b.push_back(static_cast<std::size_t>(other - b.places.begin()));
    out.a.value.push_back(place.value);
    out.a.std.push_back(place.std);
    out.b.value.push_back(other->value);
    out.b.std.push_back(other->std);
  }
  return out;
}

// The hits in which both shapes are known at every one of these places.
std::vector<std::size_t> common_hits(const CommonPlaces& common, const std::vector<std::size_t>& places,
                                     const ShapeInHits& a, const ShapeInHits& b) {
  const auto has = [](const std::vector<ValueInHit>& values, std::size_t hit) {
    return std::any_of(values.begin(), values.end(), [&](const ValueInHit& one) { return one.hit == hit; });
  };
  std::vector<std::size_t> hits;
  for (const ValueInHit& one : a[common.of_a[places.front()]]) {
    const bool everywhere = std::all_of(places.begin(), places.end(), [&](std::size_t i) {
      return has(a[common.of_a[i]], one.hit) && has(b[common.of_b[i]], one.hit);
    });
    if (everywhere) hits.push_back(one.hit);
  }
  return hits;
}

// One shape's values at one place in some hits: each hit's part of the error of their average, which is its deviation
// from the average times its weight.
struct HitParts {
  std::vector<Complex> part;   // [hits]
  std::vector<double> weight;  // [hits] Σ = 1
  double chi2 = 0;             // of the values about their mean, by the noise; 2 (hits − 1) degrees of freedom
};

HitParts hit_parts(const std::vector<ValueInHit>& values, const std::vector<std::size_t>& hits) {
  HitParts out;
  std::vector<Complex> value;
  double power = 0, inverse = 0, squares = 0;
  Complex mean, likeliest;
  for (const std::size_t hit : hits) {
    const ValueInHit& one = *std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.hit == hit; });
    const double std = std::max(one.std, kRoundingOfValue * std::abs(one.value));
    const double by_noise = std > 0 ? 1 / (std * std) : 0;
    value.push_back(one.value);
    out.weight.push_back(one.power);
    power += one.power;
    mean += one.power * one.value;
    inverse += by_noise;
    likeliest += by_noise * one.value;
    squares += by_noise * std::norm(one.value);
  }
  for (double& weight : out.weight) weight = power > 0 ? weight / power : 1 / static_cast<double>(hits.size());
  if (power > 0) mean /= power;
  for (std::size_t h = 0; h < value.size(); ++h) out.part.push_back(out.weight[h] * (value[h] - mean));
  if (inverse > 0) out.chi2 = std::max(0.0, squares - std::norm(likeliest) / inverse);
  return out;
}

// The variance of a weighted mean of equally uncertain values over the sum of squares of their parts of its error;
// n/(n − 1) for n equal weights.
double variance_over_squares(const std::vector<double>& weight) {
  double squares = 0, cubes = 0;
  for (const double w : weight) {
    squares += w * w;
    cubes += w * w * w;
  }
  const double expected = squares - 2 * cubes + squares * squares;
  return expected > 0 ? squares / expected : 0;
}

// The two shapes at one point, hit by hit.
struct PointInHits {
  std::vector<std::size_t> places;  // common places
  std::vector<HitParts> a, b;       // [places]
};

// What each hit of the point contributes to the error of the MAC: errors that several places or both modes have in
// common, as the force's gain, add up or cancel as in the MAC.
void add_point(const CommonPlaces& common, double value, const PointInHits& point, MacError& error) {
  const Products& p = error.products;
  const std::vector<double>& weight = point.a.front().weight;
  const double degrees = static_cast<double>(weight.size()) - 1, factor = variance_over_squares(weight);
  const double cross = std::abs(p.cross), size_a = std::sqrt(p.aa), size_b = std::sqrt(p.bb);
  const Complex turn = cross > 0 ? p.cross / cross : Complex(1);  // b lies along turn · a
  double first = 0, lost = 0, gained = 0;
  for (std::size_t h = 0; h < weight.size(); ++h) {
    double change = 0;
    Complex parallel;
    for (std::size_t k = 0; k < point.places.size(); ++k) {
      const std::size_t i = point.places[k];
      const Complex by_hit_a = point.a[k].part[h], by_hit_b = point.b[k].part[h];
      const Complex a = common.a.value[i], b = common.b.value[i];
      const Gradient g = gradient(common.a, common.b, p, value, i);
      change += 2 * (g.by_a * by_hit_a + g.by_b * by_hit_b).real();
      parallel += std::conj(a) * by_hit_b + std::conj(by_hit_a) * b;
      lost += std::norm(by_hit_b / size_b - turn * by_hit_a / size_a) * (1 - std::norm(a) / p.aa);
    }
    first += change * change;
    gained += std::norm(parallel);
  }
  error.first.add_estimated(factor * first, degrees);
  error.lost_by_hits.add_estimated(factor * lost, degrees);
  error.gained.add_estimated(factor * gained, degrees);
}

// By the hits, if the values scatter significantly between them; otherwise by the places' standard deviations, in which
// the noise is better known.
Mac mac_of_modes(const ModeShape& shape_a, const ModeShape& shape_b, const ShapeInHits& in_hits_a,
                 const ShapeInHits& in_hits_b) {
  const CommonPlaces common = common_places(shape_a, shape_b);
  if (in_hits_a.empty() || in_hits_b.empty()) return mac(common.a, common.b);
  const Products p = products(common.a, common.b);
  if (!(p.aa > 0) || !(p.bb > 0)) return {};
  const double value = value_of(p);
  MacError error{.products = p};
  double chi2 = 0, degrees = 0;
  for (const auto& [number, places] : common.of_point) {
    const std::vector<std::size_t> hits = common_hits(common, places, in_hits_a, in_hits_b);
    if (hits.size() < 2) {
      for (const std::size_t i : places) error.add_place(common.a, common.b, value, i);
      continue;
    }
    PointInHits point{.places = places, .a = {}, .b = {}};
    for (const std::size_t i : places) {
      point.a.push_back(hit_parts(in_hits_a[common.of_a[i]], hits));
      point.b.push_back(hit_parts(in_hits_b[common.of_b[i]], hits));
      chi2 += point.a.back().chi2 + point.b.back().chi2;
      degrees += 4 * (static_cast<double>(hits.size()) - 1);
    }
    add_point(common, value, point, error);
  }
  if (!(degrees > 0) || !(chi2_deviate(chi2, degrees) > kOnceIn1000)) return mac(common.a, common.b);
  return error.mac(value);
}

}  // namespace

Mac mac(const ShapeValues& a, const ShapeValues& b) {
  assert(a.value.size() == b.value.size() && a.std.size() == a.value.size() && b.std.size() == b.value.size());
  const Products p = products(a, b);
  if (!(p.aa > 0) || !(p.bb > 0)) return {};
  const double value = value_of(p);
  MacError error{.products = p};
  for (std::size_t i = 0; i < a.value.size(); ++i) error.add_place(a, b, value, i);
  return error.mac(value);
}

std::vector<std::vector<Mac>> auto_mac(std::span<const ModeShape> shapes, std::span<const ShapeInHits> in_hits) {
  assert(in_hits.empty() || in_hits.size() == shapes.size());
  const auto hits_of = [&](std::size_t mode) { return in_hits.empty() ? ShapeInHits{} : in_hits[mode]; };
  std::vector<std::vector<Mac>> out(shapes.size(), std::vector<Mac>(shapes.size()));
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    out[i][i] = {.value = 1, .std = 0};
    for (std::size_t j = 0; j < i; ++j)
      out[i][j] = out[j][i] = mac_of_modes(shapes[i], shapes[j], hits_of(i), hits_of(j));
  }
  return out;
}

}  // namespace percuss::identify
