#pragma once
#include <complex>
#include <span>
#include <vector>

#include "identify/shapes/mode_shapes.hpp"

namespace percuss::identify {

/// A modal assurance criterion and how far noise on the shapes puts it from its noise-free value.
struct Mac {
  double value = 0;  // 0: orthogonal, 1: the same shape
  double std = 0;
};

/// A shape's components with the deviation of the real and of the imaginary part of each.
struct ShapeValues {
  std::vector<std::complex<double>> value;
  std::vector<double> std;
};

/// MAC = |aᴴb|² / (aᴴa · bᴴb)                                                                             (1)
/// blind to complex scale. The deviation is the root mean square over noise: the gradient of (1) where it has one, and
/// the second order where it has none, at MAC 1 and 0.
/// shapes  a, b the same places in the same order. 0 ± 0 when either shape is zero everywhere.
/// source  [4] in docs/theory/sources.md.
/// theory (5.4)
Mac mac(const ShapeValues& a, const ShapeValues& b);

/// MAC between the modes of one test over the places that both have: [modes][modes], symmetric. The diagonal is 1 ± 0.
std::vector<std::vector<Mac>> auto_mac(std::span<const ModeShape> shapes);

}  // namespace percuss::identify
