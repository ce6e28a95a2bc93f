#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstddef>
#include <vector>

#include "model/bat/bat_profile.hpp"

namespace percuss::model {

/// The unknowns of an element: w (m) and θ (rad) of its start, of the bubbles within, of its end.
using ElementVector = Eigen::Matrix<double, 6, 1>;

/// A piece of a beam with the same section all along.
struct BeamElement {
  double start_m = 0, element_length_m = 0;
  double bending_Nm2 = 0;  // EI
  double shear_N = 0;      // κGA
  double mass_kgpm = 0;    // ρA
  double rotary_kgm = 0;   // ρI

  // What the unknowns add to deflection w, rotation θ of the section, w′ − θ and θ′ at a share x of the length.
  ElementVector deflection(double x) const;
  ElementVector rotation(double x) const;
  ElementVector shear(double x) const;
  ElementVector curvature(double x) const;
};

/// A beam by finite elements after Timoshenko, with rotary inertia. The shapes of an element's ends are those of a
/// static one loaded there (w cubic, θ quadratic, w′ − θ constant), so that thin elements do not lock; a parabola
/// within for w and one for θ make the error of a frequency fall with the fourth power of the element's length.
///   K q = ω² M q                                                                                        (1)
/// theory (12.1)
struct TimoshenkoBeam {
  std::vector<BeamElement> elements;
  Eigen::SparseMatrix<double> stiffness, mass;  // [unknowns, unknowns]
};

inline constexpr Eigen::Index kUnknownsPerElement = 4;  // and two more at the beam's end

/// The bat with free ends; slices longer than max_element_length_m are cut into equal elements.
TimoshenkoBeam timoshenko_beam(const BatProfile& profile, const BatMaterial& material, double max_element_length_m);

/// Where each element starts, and the beam's end. shape [elements + 1].
std::vector<double> positions_of(const TimoshenkoBeam& beam);

/// The element around z_m, by its index; the last one for the beam's end.
std::size_t element_at(const TimoshenkoBeam& beam, double z_m);

}  // namespace percuss::model
