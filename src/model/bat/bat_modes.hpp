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

/// The elastic modes of a bat or beam: the solutions of (1) in timoshenko_elements.hpp with ω > 0. They are orthonormal
/// with respect to the full mass matrix,
///   shape_r · M · shape_s = 1 for r = s, else 0,                                                        (1)
/// and M-orthogonal to the rigid-body modes: two of a free bat, one of a bat on a pin, none otherwise.
/// theory (12.2)
struct BatModes {
  TimoshenkoBeam beam;
  BatInertia inertia;
  StructureSupport support;
  double length_m = 0;
  Eigen::VectorXd freq_Hz;  // ascending
  Eigen::MatrixXd shape;    // [unknowns, modes], 1/√kg and its slope

  /// Deflections of the elastic modes at z_m from the knob, 1/√kg. shape [modes].
  Eigen::VectorXd deflection(double z_m) const;
  /// Deflections of the rigid-body modes. Free: 1/√M and (z − cm)/√I. On a pin at s: 0 and (z − s)/√(I + M (s − cm)²).
  /// Otherwise both are 0: there is none.
  Eigen::Vector2d rigid_deflection(double z_m) const;
  /// 1/M_e at z_m of the rigid bat: free, or about its pin or its spring's pin. 0 where a clamp holds it.
  double rigid_accelerance_per_kg(double z_m) const;
};

/// Computes the elastic modes with the lowest frequencies.
/// errors  InputError where the values differ by so many decades that rounding hides the modes.
BatModes bat_modes(const BeamStructure& structure, const BatModesOptions& options = {});
BatModes bat_modes(const BatProfile& profile, const BatMaterial& material, const BatModesOptions& options = {});

/// The nodes of a mode, from the knob, from the shape functions of each element. The support is not one of them.
std::vector<double> nodes_of(const BatModes& modes, std::size_t mode);

}  // namespace percuss::model
