#include "model/bat/timoshenko_elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace percuss::model {
namespace {

using Eigen::Index;
using ElementMatrix = Eigen::Matrix<double, 6, 6>;
using Triplets = std::vector<Eigen::Triplet<double>>;

// Gauss–Legendre points on 0 … 1: four are exact to degree 7, and the squared shape functions have degree 6.
constexpr std::array<double, 4> kGaussAt{0.0694318442029737, 0.3300094782075719, 0.6699905217924281,
                                         0.9305681557970263};
constexpr std::array<double, 4> kGaussWeight{0.1739274225687269, 0.3260725774312731, 0.3260725774312731,
                                             0.1739274225687269};

// The ratio of bending to shear stiffness: 12 EI / (κGA h²).
double shear_parameter(const BeamElement& e) {
  return 12 * e.bending_Nm2 / (e.shear_N * e.element_length_m * e.element_length_m);
}

// Adds factor · shape shapeᵀ: one Gauss point of an integral over the element.
void add_square(ElementMatrix& sum, double factor, const ElementVector& shape) {
  sum += factor * shape * shape.transpose();
}

void add_element(const BeamElement& e, Index first, Triplets& stiffness, Triplets& mass) {
  ElementMatrix k = ElementMatrix::Zero(), m = ElementMatrix::Zero();
  for (std::size_t i = 0; i < kGaussAt.size(); ++i) {
    const double x = kGaussAt.at(i), weight_m = kGaussWeight.at(i) * e.element_length_m;
    add_square(k, weight_m * e.bending_Nm2, e.curvature(x));
    add_square(k, weight_m * e.shear_N, e.shear(x));
    add_square(m, weight_m * e.mass_kgpm, e.deflection(x));
    add_square(m, weight_m * e.rotary_kgm, e.rotation(x));
  }
  for (Index row = 0; row < k.rows(); ++row) {
    for (Index column = 0; column < k.cols(); ++column) {
      stiffness.emplace_back(first + row, first + column, k(row, column));
      mass.emplace_back(first + row, first + column, m(row, column));
    }
  }
}

BeamElement element_of(double diameter_m, double start_m, double element_length_m, const BatMaterial& material) {
  const double area_m2 = std::numbers::pi / 4 * diameter_m * diameter_m;
  const double second_m4 = area_m2 * diameter_m * diameter_m / 16;
  return {.start_m = start_m,
          .element_length_m = element_length_m,
          .bending_Nm2 = material.young_Pa * second_m4,
          .shear_N = material.shear_Pa * area_m2,
          .mass_kgpm = material.density_kgpm3 * area_m2,
          .rotary_kgm = material.density_kgpm3 * second_m4};
}

}  // namespace

ElementVector BeamElement::deflection(double x) const {
  const double p = shear_parameter(*this), x2 = x * x, x3 = x2 * x, h = element_length_m / (1 + p),
               bubble = 4 * x * (1 - x);
  return {(1 + p * (1 - x) - 3 * x2 + 2 * x3) / (1 + p), h * ((1 + p / 2) * x - (2 + p / 2) * x2 + x3), bubble, 0,
          (p * x + 3 * x2 - 2 * x3) / (1 + p),           h * (-p / 2 * x - (1 - p / 2) * x2 + x3)};
}

ElementVector BeamElement::rotation(double x) const {
  const double p = shear_parameter(*this), f = 6 / ((1 + p) * element_length_m) * (x * x - x), bubble = 4 * x * (1 - x);
  return {f, (1 + p - (4 + p) * x + 3 * x * x) / (1 + p), 0, bubble, -f, ((p - 2) * x + 3 * x * x) / (1 + p)};
}

ElementVector BeamElement::shear(double x) const {
  const double p = shear_parameter(*this), f = p / (1 + p);
  return {-f / element_length_m, -f / 2, 4 * (1 - 2 * x) / element_length_m, -4 * x * (1 - x),
          f / element_length_m,  -f / 2};
}

ElementVector BeamElement::curvature(double x) const {
  const double p = shear_parameter(*this), f = 6 / ((1 + p) * element_length_m) * (2 * x - 1) / element_length_m;
  return {f,  (6 * x - 4 - p) / (1 + p) / element_length_m, 0, 4 * (1 - 2 * x) / element_length_m,
          -f, (6 * x - 2 + p) / (1 + p) / element_length_m};
}

TimoshenkoBeam timoshenko_beam(const BatProfile& profile, const BatMaterial& material, double max_element_length_m) {
  TimoshenkoBeam beam;
  double start_m = 0;
  for (std::size_t i = 0; i < profile.end_m.size(); ++i) {
    const double slice_m = profile.end_m[i] - start_m;
    const int parts = std::max(1, static_cast<int>(std::ceil(slice_m / max_element_length_m * (1 - 1e-9))));
    for (int part = 0; part < parts; ++part) {
      beam.elements.push_back(
          element_of(profile.diameter_m[i], start_m + part * slice_m / parts, slice_m / parts, material));
    }
    start_m = profile.end_m[i];
  }
  Triplets stiffness, mass;
  stiffness.reserve(36 * beam.elements.size());
  mass.reserve(36 * beam.elements.size());
  Index first = 0;
  for (const BeamElement& e : beam.elements) {
    add_element(e, first, stiffness, mass);
    first += kUnknownsPerElement;
  }
  beam.stiffness.resize(first + 2, first + 2);
  beam.mass.resize(first + 2, first + 2);
  beam.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
  beam.mass.setFromTriplets(mass.begin(), mass.end());
  return beam;
}

std::vector<double> positions_of(const TimoshenkoBeam& beam) {
  std::vector<double> all;
  all.reserve(beam.elements.size() + 1);
  for (const BeamElement& e : beam.elements) all.push_back(e.start_m);
  all.push_back(beam.elements.back().start_m + beam.elements.back().element_length_m);
  return all;
}

std::size_t element_at(const TimoshenkoBeam& beam, double z_m) {
  const auto after = std::upper_bound(beam.elements.begin(), beam.elements.end(), z_m,
                                      [](double z, const BeamElement& e) { return z < e.start_m; });
  return after == beam.elements.begin() ? 0 : static_cast<std::size_t>(after - beam.elements.begin()) - 1;
}

}  // namespace percuss::model
