#include "identify/shapes/mac.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace percuss::identify {
namespace {

using Complex = std::complex<double>;

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

// First order: |∂MAC/∂b_i|² σ_i² for real and imaginary part, and likewise for a.
double first_order(const ShapeValues& a, const ShapeValues& b, const Products& p, double value) {
  double variance = 0;
  for (std::size_t i = 0; i < a.value.size(); ++i) {
    const Complex by_b =
        std::conj(p.cross) * std::conj(a.value[i]) / (p.aa * p.bb) - value * std::conj(b.value[i]) / p.bb;
    const Complex by_a = p.cross * std::conj(b.value[i]) / (p.aa * p.bb) - value * std::conj(a.value[i]) / p.aa;
    variance += 4 * (std::norm(by_b) * b.std[i] * b.std[i] + std::norm(by_a) * a.std[i] * a.std[i]);
  }
  return variance;
}

// Noise orthogonal to a shape lowers a MAC of 1 by its energy over the shape's energy.
double lost_to_noise(const ShapeValues& shape, double energy) {
  double lost = 0;
  for (std::size_t i = 0; i < shape.value.size(); ++i)
    lost += 2 * shape.std[i] * shape.std[i] * (1 - std::norm(shape.value[i]) / energy);
  return lost / energy;
}

// Noise parallel to the other shape raises a MAC of 0. The rise is exponentially distributed: its rms is √2 times its
// mean.
double gained_by_noise(const ShapeValues& a, const ShapeValues& b, const Products& p) {
  double gained = 0;
  for (std::size_t i = 0; i < a.value.size(); ++i) {
    gained += 2 * b.std[i] * b.std[i] * std::norm(a.value[i]) + 2 * a.std[i] * a.std[i] * std::norm(b.value[i]);
  }
  return std::sqrt(2.0) * gained / (p.aa * p.bb);
}

// The values of both shapes at their common places.
void common_places(const ModeShape& a, const ModeShape& b, ShapeValues& a_out, ShapeValues& b_out) {
  for (const ShapePlace& place : a.places) {
    const auto other = std::find_if(b.places.begin(), b.places.end(), [&](const ShapePlace& p) {
      return p.point == place.point && p.channel == place.channel;
    });
    if (other == b.places.end()) continue;
    a_out.value.push_back(place.value);
    a_out.std.push_back(place.std);
    b_out.value.push_back(other->value);
    b_out.std.push_back(other->std);
  }
}

}  // namespace

Mac mac(const ShapeValues& a, const ShapeValues& b) {
  assert(a.value.size() == b.value.size() && a.std.size() == a.value.size() && b.std.size() == b.value.size());
  const Products p = products(a, b);
  if (!(p.aa > 0) || !(p.bb > 0)) return {};
  const double value = std::min(1.0, std::norm(p.cross) / (p.aa * p.bb));  // (1)
  const double lost = value * (lost_to_noise(a, p.aa) + lost_to_noise(b, p.bb));
  const double gained = (1 - value) * gained_by_noise(a, b, p);
  return {.value = value, .std = std::sqrt(first_order(a, b, p, value) + lost * lost + gained * gained)};
}

std::vector<std::vector<Mac>> auto_mac(std::span<const ModeShape> shapes) {
  std::vector<std::vector<Mac>> out(shapes.size(), std::vector<Mac>(shapes.size()));
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    out[i][i] = {.value = 1, .std = 0};
    for (std::size_t j = 0; j < i; ++j) {
      ShapeValues a, b;
      common_places(shapes[i], shapes[j], a, b);
      out[i][j] = out[j][i] = mac(a, b);
    }
  }
  return out;
}

}  // namespace percuss::identify
