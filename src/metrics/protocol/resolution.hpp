#pragma once

namespace percuss::metrics {

/// Standard deviation of a reading taken to the nearest `step`: its error is anywhere within half a step either way.
///   σ = step/√12                                                                               (P0)
double reading_std(double step);

/// `value` as it is recorded: to the nearest whole number of steps, halves away from zero. A step of 0 changes nothing.
double recorded(double value, double step);

/// What limits on readings leave to the binary form of decimal numbers: 146.4 − 145.4 is a little more than 1.
inline constexpr double kReadingTolerance = 1e-9;

/// The steps to which a bat and a ball are read, [8] in docs/theory/sources.md, sections 3.2 and 3.4. In the units of the
/// instruments, as the protocol says them.
struct ProtocolSteps {
  double length_in = 0.0625, diameter_in = 0.001, weight_oz = 0.005, cg_in = 0.0625, ball_g = 0.1;
};

}  // namespace percuss::metrics
