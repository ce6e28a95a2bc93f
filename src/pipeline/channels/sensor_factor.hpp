#pragma once
#include <optional>
#include <vector>

namespace percuss::pipeline {

/// The ratio of a mode's residues at two sensors of a tube, 90° apart: A₂/A₁ of the stated scales.
struct SensorRatio {
  double freq_Hz = 0, ratio = 0;
  double angle_std_rad = 0;  // of atan(ratio)
};

/// Any factor above 3 (or below 1/3) by which the second sensor's scale is wrong, as with exchanged sensitivities.
struct SensorFactor {
  double factor = 1;
  std::vector<double> hoop_ratios;  // the ratios of the modes that show it
};

/// The factor that the ratios show, if no tube with right scales has them. With the factor c, hoop modes have the ratio
/// −c, and bending modes c tan ψ or −c cot ψ, with ψ the plane of the blow or of the tube:
///  1. Two modes of different frequency or more have one negative ratio −c, and two bending modes or more lie below.
///  2. Of three bending modes or more below twice the lowest hoop mode, all divided by c lie in one plane or at right
///     angles to it.
///  3. No plane of the measured ratios is at right angles to another one: the scales are right then, because the two
///     planes of a tube are at right angles for c = ±1 alone.
///  4. No mode near the hoop modes has the ratio −1 of right scales.
///  5. No bending mode is near ±45°: there the sensors are at nodes of the hoop modes, and small errors of the angles
///     give them any ratio.
/// The ratios ascend in frequency. theory, 6.8
std::optional<SensorFactor> sensor_factor(const std::vector<SensorRatio>& ratios);

}  // namespace percuss::pipeline
