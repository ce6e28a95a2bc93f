#include "model/bat/timoshenko_elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace percuss::model {
namespace {

using Eigen::Index;
using ElementMatrix = Eigen::Matrix<double, 6, 6>;
using Triplets = std::vector<Eigen::Triplet<double>>;

// Gauss–Legendre points on 0 … 1: four are exact to degree 7, and the squared shape functions have degree 6.
constexpr std::array<double, kGaussPoints> kGaussAt{0.0694318442029737, 0.3300094782075719, 0.6699905217924281,
                                                    0.9305681557970263};
constexpr std::array<double, kGaussPoints> kGaussWeight{0.1739274225687269, 0.3260725774312731, 0.3260725774312731,
                                                        0.1739274225687269};
constexpr double kSamePlace = 1e-9;  // of the beam's length: positions closer than this are one node

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
  for (std::size_t i = 0; i < kGaussPoints; ++i) {
    const double x = kGaussAt.at(i), weight_m = kGaussWeight.at(i) * e.element_length_m;
    const BeamSection& section = e.at_gauss.at(i);
    add_square(k, weight_m * section.bending_Nm2, e.curvature(x));
    if (std::isfinite(e.shear_N)) add_square(k, weight_m * section.shear_N, e.shear(x));
    add_square(m, weight_m * section.mass_kgpm, e.deflection(x));
    add_square(m, weight_m * section.rotary_kgm, e.rotation(x));
  }
  for (Index row = 0; row < k.rows(); ++row) {
    for (Index column = 0; column < k.cols(); ++column) {
      stiffness.emplace_back(first + row, first + column, k(row, column));
      mass.emplace_back(first + row, first + column, m(row, column));
    }
  }
}

// The mass per length of masses that are spread over the element at x_m.
double spread_kgpm(const BeamStructure& structure, double x_m) {
  double sum = 0;
  for (const AddedMass& one : structure.added) {
    if (one.to_m > one.from_m && x_m > one.from_m && x_m < one.to_m) sum += one.mass_kg / (one.to_m - one.from_m);
  }
  return sum;
}

BeamElement element_of(const BeamStructure& structure, std::size_t station, double start_m, double element_length_m) {
  BeamElement e{.start_m = start_m, .element_length_m = element_length_m};
  const double spread = spread_kgpm(structure, start_m + element_length_m / 2);
  for (std::size_t i = 0; i < kGaussPoints; ++i) {
    BeamSection& section = e.at_gauss.at(i);
    section = section_at(structure.table, structure.material, station, start_m + kGaussAt.at(i) * element_length_m);
    section.mass_kgpm += spread;
    if (structure.slender) section.rotary_kgm = 0;
    e.bending_Nm2 += kGaussWeight.at(i) * section.bending_Nm2;
    e.shear_N += kGaussWeight.at(i) * section.shear_N;
    e.mass_kgpm += kGaussWeight.at(i) * section.mass_kgpm;
  }
  if (structure.slender) e.shear_N = std::numeric_limits<double>::infinity();
  return e;
}

// Positions inside the beam, besides the stations, at which a node must lie; ascending.
std::vector<double> extra_nodes(const BeamStructure& structure) {
  std::vector<double> all;
  if (structure.support.kind != BeamSupport::free) all.push_back(structure.support.at_m);
  for (const AddedMass& one : structure.added) all.insert(all.end(), {one.from_m, one.to_m});
  std::sort(all.begin(), all.end());
  return all;
}

void add_stretch(const BeamStructure& structure, std::size_t station, double start_m, double end_m, double max_m,
                 std::vector<BeamElement>& elements) {
  const double stretch_m = end_m - start_m;
  const int parts = std::max(1, static_cast<int>(std::ceil(stretch_m / max_m * (1 - 1e-9))));
  for (int part = 0; part < parts; ++part)
    elements.push_back(element_of(structure, station, start_m + part * stretch_m / parts, stretch_m / parts));
}

std::vector<BeamElement> elements_of(const BeamStructure& structure, double max_m) {
  const double same_m = kSamePlace * structure.length_m();
  const std::vector<double> extra = extra_nodes(structure);
  std::vector<BeamElement> elements;
  for (std::size_t i = 0; i < structure.table.stations.size(); ++i) {
    double start_m = structure.table.start_m(i);
    const double end_m = structure.table.stations[i].at_m;
    for (const double node_m : extra) {
      if (node_m <= start_m + same_m || node_m >= end_m - same_m) continue;
      add_stretch(structure, i, start_m, node_m, max_m, elements);
      start_m = node_m;
    }
    if (end_m > start_m) add_stretch(structure, i, start_m, end_m, max_m, elements);
  }
  return elements;
}

std::size_t node_at(const TimoshenkoBeam& beam, double x_m) {
  const std::vector<double> at_m = positions_of(beam);
  const auto nearest = std::min_element(at_m.begin(), at_m.end(),
                                        [&](double a, double b) { return std::abs(a - x_m) < std::abs(b - x_m); });
  return static_cast<std::size_t>(nearest - at_m.begin());
}

Index deflection_unknown(std::size_t node) { return kUnknownsPerElement * static_cast<Index>(node); }

void fix_unknowns(const BeamStructure& structure, TimoshenkoBeam& beam) {
  if (structure.support.kind != BeamSupport::free) {
    const Index unknown = deflection_unknown(node_at(beam, structure.support.at_m));
    beam.fixed.push_back(unknown);
    if (structure.support.kind == BeamSupport::clamped) beam.fixed.push_back(unknown + 1);
  }
  if (!structure.slender) return;
  for (std::size_t i = 0; i < beam.elements.size(); ++i) {
    beam.fixed.push_back(deflection_unknown(i) + 2);
    beam.fixed.push_back(deflection_unknown(i) + 3);
  }
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

TimoshenkoBeam timoshenko_beam(const BeamStructure& structure, double max_element_length_m) {
  TimoshenkoBeam beam;
  beam.elements = elements_of(structure, max_element_length_m);
  for (const AddedMass& one : structure.added) {
    if (!(one.to_m > one.from_m)) beam.masses.push_back({.node = node_at(beam, one.from_m), .mass_kg = one.mass_kg});
  }
  fix_unknowns(structure, beam);
  Triplets stiffness, mass;
  stiffness.reserve(36 * beam.elements.size());
  mass.reserve(36 * beam.elements.size());
  Index first = 0;
  for (const BeamElement& e : beam.elements) {
    add_element(e, first, stiffness, mass);
    first += kUnknownsPerElement;
  }
  for (const NodeMass& one : beam.masses) {
    const Index unknown = deflection_unknown(one.node);
    mass.emplace_back(unknown, unknown, one.mass_kg);
  }
  if (structure.support.kind == BeamSupport::torsion) {
    const Index unknown = deflection_unknown(node_at(beam, structure.support.at_m)) + 1;
    stiffness.emplace_back(unknown, unknown, structure.support.torsion_Nmprad);
  }
  beam.stiffness.resize(first + 2, first + 2);
  beam.mass.resize(first + 2, first + 2);
  beam.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
  beam.mass.setFromTriplets(mass.begin(), mass.end());
  return beam;
}

TimoshenkoBeam timoshenko_beam(const BatProfile& profile, const BatMaterial& material, double max_element_length_m) {
  return timoshenko_beam(structure_of(profile, material), max_element_length_m);
}

BatInertia inertia_of(const TimoshenkoBeam& beam) {
  BatInertia sum;
  double about_origin = 0;
  const auto add = [&](double mass_kg, double x_m) {
    sum.mass_kg += mass_kg;
    sum.cm_m += mass_kg * x_m;
    about_origin += mass_kg * x_m * x_m;
  };
  for (const BeamElement& e : beam.elements) {
    for (std::size_t i = 0; i < kGaussPoints; ++i) {
      const double weight_m = kGaussWeight.at(i) * e.element_length_m;
      add(weight_m * e.at_gauss.at(i).mass_kgpm, e.start_m + kGaussAt.at(i) * e.element_length_m);
      about_origin += weight_m * e.at_gauss.at(i).rotary_kgm;
    }
  }
  const std::vector<double> at_m = positions_of(beam);
  for (const NodeMass& one : beam.masses) add(one.mass_kg, at_m[one.node]);
  sum.cm_m /= sum.mass_kg;
  sum.inertia_kgm2 = about_origin - sum.mass_kg * sum.cm_m * sum.cm_m;
  return sum;
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
