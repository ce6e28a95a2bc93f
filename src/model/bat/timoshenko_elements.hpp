#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <cstddef>
#include <vector>

#include "model/bat/bat_profile.hpp"
#include "model/bat/beam_structure.hpp"

namespace percuss::model {

/// The unknowns of an element: w (m) and θ (rad) at its start, the amplitudes of the bubble functions of w and θ, then
/// w and θ at its end.
using ElementVector = Eigen::Matrix<double, 6, 1>;

inline constexpr std::size_t kGaussPoints = 4;

/// An element. Its section may change along it; the shape functions belong to the mean of EI and of κGA.
struct BeamElement {
  double start_m = 0, element_length_m = 0;
  double bending_Nm2 = 0;  // mean EI
  double shear_N = 0;      // mean κGA; infinite without shear deformation
  double mass_kgpm = 0;    // mean ρA
  std::array<BeamSection, kGaussPoints> at_gauss{};

  // Shape functions of deflection w, rotation θ of the section, shear w′ − θ and curvature θ′, at x = 0 … 1.
  ElementVector deflection(double x) const;
  ElementVector rotation(double x) const;
  ElementVector shear(double x) const;
  ElementVector curvature(double x) const;
};

/// A mass at a node of the elements.
struct NodeMass {
  std::size_t node = 0;  // index into positions_of(beam)
  double mass_kg = 0;
};

/// A Timoshenko beam of finite elements, with rotary inertia. The shape functions of an element's ends are its static
/// deflections under end loads: w cubic, θ quadratic, w′ − θ constant. Thin elements therefore do not lock in shear. A
/// parabolic bubble function each for w and θ makes the error of a frequency fall with the fourth power of the element
/// length. Without shear deformation the bubbles vanish, and w is cubic with θ = w′.
///   K q = ω² M q                                                                                        (1)
/// theory (12.1)
struct TimoshenkoBeam {
  std::vector<BeamElement> elements;
  std::vector<NodeMass> masses;
  Eigen::SparseMatrix<double> stiffness, mass;  // [unknowns, unknowns]
  std::vector<Eigen::Index> fixed;              // unknowns that are zero: of the support, and bubbles that vanish
};

inline constexpr Eigen::Index kUnknownsPerElement = 4;  // plus two at the end of the beam

/// Builds the elements. A node lies at every station of the table, at the support, and at both ends of an added mass. A
/// stretch longer than max_element_length_m becomes several equal elements.
/// Preconditions: support and added masses lie on the beam.
TimoshenkoBeam timoshenko_beam(const BeamStructure& structure, double max_element_length_m);
TimoshenkoBeam timoshenko_beam(const BatProfile& profile, const BatMaterial& material, double max_element_length_m);

/// The rigid-body properties of a beam.
struct BatInertia {
  double mass_kg = 0;
  double cm_m = 0;          // centre of mass, from x = 0
  double inertia_kgm2 = 0;  // about a transverse axis through the centre of mass
};

/// Exact for constant and for linearly changing dimensions, except in an element in which a wall reaches the axis.
BatInertia inertia_of(const TimoshenkoBeam& beam);

/// The start of each element, and the end of the beam. shape [elements + 1].
std::vector<double> positions_of(const TimoshenkoBeam& beam);

/// The index of the element that contains z_m; the last one for the end of the beam.
std::size_t element_at(const TimoshenkoBeam& beam, double z_m);

}  // namespace percuss::model
