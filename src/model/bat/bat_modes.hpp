#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "model/bat/timoshenko_elements.hpp"

namespace percuss::model {

struct BatModesOptions {
  std::size_t modes = 40;  // elastic ones, from the lowest; as many as the elements give if there are fewer
  double max_element_fraction = 1.0 / 84;  // of an element, of the bat's length
};

/// A free bat's elastic modes: solutions of (1) in timoshenko_elements.hpp with ω > 0, orthonormal in the full mass
/// matrix,
///   shape_r · M · shape_s = 1 for r = s, else 0,                                                        (1)
/// and orthogonal in it to the bat's two motions as a rigid body.
/// theory (12.2)
struct BatModes {
  TimoshenkoBeam beam;
  BatInertia inertia;
  double length_m = 0;
  Eigen::VectorXd freq_Hz;  // ascending
  Eigen::MatrixXd shape;    // [2 nodes, modes], 1/√kg and its slope

  /// The modes' deflections at z_m from the knob, 1/√kg. shape [modes].
  Eigen::VectorXd deflection(double z_m) const;
  /// … those of the two rigid-body motions: 1/√M and (z − cm)/√I.
  Eigen::Vector2d rigid_deflection(double z_m) const;
};

/// errors  InputError: numbers so far apart that no mode can be told from rounding.
BatModes bat_modes(const BatProfile& profile, const BatMaterial& material, const BatModesOptions& options = {});

/// Where a mode's deflection is zero, from the knob: found within each element by its own shapes.
std::vector<double> nodes_of(const BatModes& modes, std::size_t mode);

}  // namespace percuss::model
