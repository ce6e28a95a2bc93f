#pragma once
#include <complex>
#include <span>
#include <vector>

#include "identify/shapes/mode_shapes.hpp"

namespace percuss::identify {

/// A modal assurance criterion, with the rms error from the noise on both shapes.
struct Mac {
  double value = 0;  // 0: orthogonal, 1: the same shape
  double std = 0;
};

/// A shape's components, with the standard deviation of each component's real and of its imaginary part.
struct ShapeValues {
  std::vector<std::complex<double>> value;
  std::vector<double> std;
};

/// MAC = |aᴴb|² / (aᴴa · bᴴb)                                                                             (1)
/// It does not depend on the complex scale of the shapes. Its standard deviation is the rms error that noise causes:
/// from the gradient of (1), and from the second order at MAC 1 and 0, where the gradient is zero.
/// shapes  a, b the same places in the same order. 0 ± 0 where either shape is zero everywhere.
/// source  [4] in docs/theory/sources.md.
/// theory (5.4)
Mac mac(const ShapeValues& a, const ShapeValues& b);

/// MAC between the modes of one test over their common places: [modes][modes], symmetric. The diagonal is 1 ± 0.
std::vector<std::vector<Mac>> auto_mac(std::span<const ModeShape> shapes);

}  // namespace percuss::identify
