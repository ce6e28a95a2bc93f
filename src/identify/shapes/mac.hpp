#pragma once
#include <complex>
#include <cstddef>
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
/// The deviation is at most the larger of MAC and 1 − MAC, since a MAC lies between 0 and 1.
/// theory (5.4)
Mac mac(const ShapeValues& a, const ShapeValues& b);

/// A mode's shape at one place in one hit, in the units of ModeShape::places.
struct ValueInHit {
  std::size_t hit = 0;
  double power = 0;  // the hit's weight in the average of the point
  Complex value;
  double std = 0;  // of the real and of the imaginary part, from the noise of the hit
};

/// [ModeShape::places] the values in the hits of the place's point, in the order of the hits. Empty: not known.
using ShapeInHits = std::vector<std::vector<ValueInHit>>;

/// MAC between the modes of one test over their common places: [modes][modes], symmetric. The diagonal is 1 ± 0.
/// in_hits  [modes] or empty. Where the values of two modes scatter significantly between the hits of a point, their
///          standard deviation follows from the hits: from what each hit contributes to the error of the MAC, and from
///          the points together. A mode without values in hits keeps the standard deviations of its places.
/// theory (5.14)
std::vector<std::vector<Mac>> auto_mac(std::span<const ModeShape> shapes, std::span<const ShapeInHits> in_hits = {});

}  // namespace percuss::identify
