#pragma once
#include <cstdint>
#include <initializer_list>
#include <random>
#include <span>

namespace percuss::synth {

/// Random numbers that are the same with every standard library: the 64-bit Mersenne twister (the C++ standard
/// specifies its output), 53-bit uniforms, and normals by the Box–Muller transform
///   √(−2 ln(1 − U₁)) (cos 2πU₂, sin 2πU₂)                                  (1)
/// Integers (seed, purpose, row, channel, …) name a stream, so the numbers of one row never depend on another row.
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
