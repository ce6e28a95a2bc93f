#pragma once

namespace percuss::metrics {

/// The standard deviation of a reading to the nearest `step`: its error is uniform within half a step either way.
///   σ = step/√12                                                                               (P0)
double reading_std(double step);

/// Rounds a value to the nearest multiple of `step`, halves away from zero. A step of 0 changes nothing.
double round_to_step(double value, double step);

/// Tolerance for the binary form of decimal readings at a limit: 0.690 − 0.676 is slightly less than 0.014.
inline constexpr double kReadingTolerance = 1e-9;

/// The resolutions of the readings of bat and ball, [8] in docs/theory/sources.md, sections 3.2 and 3.4, in the units
/// of the protocol.
struct ProtocolSteps {
  double length_in = 0.0625, diameter_in = 0.001, weight_oz = 0.005, cg_in = 0.0625, ball_g = 0.1;
};

}  // namespace percuss::metrics
