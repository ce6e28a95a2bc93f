#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "model/bat/timoshenko_elements.hpp"

namespace percuss::model {

struct BatModesOptions {
  std::size_t modes = 40;                  // lowest elastic modes; all of them where there are fewer
  double max_element_fraction = 1.0 / 84;  // longest element, as a fraction of the bat's length
};

/// The elastic modes of a free bat: the solutions of (1) in timoshenko_elements.hpp with ω > 0. They are orthonormal
/// with respect to the full mass matrix,
///   shape_r · M · shape_s = 1 for r = s, else 0,                                                        (1)
/// and M-orthogonal to the two rigid-body modes.
/// theory (12.2)
struct BatModes {
  TimoshenkoBeam beam;
  BatInertia inertia;
  double length_m = 0;
  Eigen::VectorXd freq_Hz;  // ascending
  Eigen::MatrixXd shape;    // [unknowns, modes], 1/√kg and its slope

  /// Deflections of the elastic modes at z_m from the knob, 1/√kg. shape [modes].
  Eigen::VectorXd deflection(double z_m) const;
  /// Deflections of the two rigid-body modes: 1/√M and (z − cm)/√I.
  Eigen::Vector2d rigid_deflection(double z_m) const;
};

/// Computes the elastic modes with the lowest frequencies.
/// errors  InputError where the values differ by so many decades that rounding hides the modes.
BatModes bat_modes(const BatProfile& profile, const BatMaterial& material, const BatModesOptions& options = {});

/// The nodes of a mode, from the knob, from the shape functions of each element.
std::vector<double> nodes_of(const BatModes& modes, std::size_t mode);

}  // namespace percuss::model
