#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstddef>
#include <vector>

#include "model/bat/bat_profile.hpp"

namespace percuss::model {

/// The unknowns of an element: w (m) and θ (rad) at its start, the amplitudes of the bubble functions of w and θ, then
/// w and θ at its end.
using ElementVector = Eigen::Matrix<double, 6, 1>;

/// An element with a constant section.
struct BeamElement {
  double start_m = 0, element_length_m = 0;
  double bending_Nm2 = 0;  // EI
  double shear_N = 0;      // κGA
  double mass_kgpm = 0;    // ρA
  double rotary_kgm = 0;   // ρI

  // Shape functions of deflection w, rotation θ of the section, shear w′ − θ and curvature θ′, at x = 0 … 1.
  ElementVector deflection(double x) const;
  ElementVector rotation(double x) const;
  ElementVector shear(double x) const;
  ElementVector curvature(double x) const;
};

/// A Timoshenko beam of finite elements, with rotary inertia. The shape functions of an element's ends are its static
/// deflections under end loads: w cubic, θ quadratic, w′ − θ constant. Thin elements therefore do not lock in shear. A
/// parabolic bubble function each for w and θ makes the error of a frequency fall with the fourth power of the element
/// length.
///   K q = ω² M q                                                                                        (1)
/// theory (12.1)
struct TimoshenkoBeam {
  std::vector<BeamElement> elements;
  Eigen::SparseMatrix<double> stiffness, mass;  // [unknowns, unknowns]
};

inline constexpr Eigen::Index kUnknownsPerElement = 4;  // plus two at the end of the beam

/// Builds a bat with free ends. A slice longer than max_element_length_m becomes several equal elements.
TimoshenkoBeam timoshenko_beam(const BatProfile& profile, const BatMaterial& material, double max_element_length_m);

/// The start of each element, and the end of the beam. shape [elements + 1].
std::vector<double> positions_of(const TimoshenkoBeam& beam);

/// The index of the element that contains z_m; the last one for the end of the beam.
std::size_t element_at(const TimoshenkoBeam& beam, double z_m);

}  // namespace percuss::model
