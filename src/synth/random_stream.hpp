#pragma once
#include <cstdint>
#include <initializer_list>
#include <random>
#include <span>

namespace percuss::synth {

/// Random numbers that are the same with every standard library: the 64-bit Mersenne twister (its output is part of the
/// C++ standard), 53-bit uniforms, and normals by Box and Muller's transform
///   √(−2 ln(1 − U₁)) (cos 2πU₂, sin 2πU₂)                                  (1)
/// A stream is named by integers (seed, purpose, row, channel, …), so that what one row draws never depends on another.
class RandomStream {
 public:
  explicit RandomStream(std::initializer_list<std::uint64_t> name);
  /// Uniform in [0, 1).
  double uniform();
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Adds normals of standard deviation `sigma`, in pairs by (1).
  void add_normal(double sigma, std::span<double> to);

 private:
  std::mt19937_64 engine_;
};

}  // namespace percuss::synth
