#pragma once
#include <span>
#include <vector>

#include "identify/shapes/scan_shape.hpp"

namespace percuss::identify {

/// The amplitude of a mode in one hit, on the scale of a ScanShape.
struct AmplitudeOfHit {
  double value = 0;
  double std = 0;       // from the noise of the hit
  double power = 1;     // its weight in the average over the hits of its point
  std::size_t hit = 0;  // the same number in all modes
};

/// A mode along a scan, and its amplitude in each hit: [points of the shape][hits].
struct HitsAlongScan {
  ScanShape shape;
  std::vector<std::vector<AmplitudeOfHit>> hits;
};

/// The scatter of the hits of a scan about their points, common to all points of a mode.
struct ScanScatter {
  double position_std_m = 0;      // of a hit along the scan
  double relative_std = 0;        // of a hit's amplitude, from its direction and the gain of the hammer
  double degrees_of_freedom = 0;  // hits less points
  double of_amplitude = 0;        // scatter of a hit beyond its noise at a typical point, over the mode's rms amplitude
};

/// The variance of one hit's amplitude about the mean of its point is taken as
///   σ² = σ_noise² + (φ′ σ_x)² + (φ σ_g)²                                                                     (1)
/// with the shape φ and its slope φ′ at the point. σ_x and σ_g are fitted to the variances of all points and modes, by
/// weighted least squares with weights from (1), because the few hits of one point hardly determine their scatter. If
/// some modes scatter far more or less than this (the variance of a typical point by a factor of four), the largest set
/// of modes that agree shares its scatter, and each other mode has its own. Such modes depend on the direction or the
/// sideways place of the hits.
/// Returns [modes]. Empty if the hits do not scatter significantly beyond their noise, or if no point has two hits.
/// theory (5.10)
std::vector<ScanScatter> scatter_along_scan(std::span<const HitsAlongScan> modes);

/// The shape with the standard deviations of the means over the hits of each point, from (1). A point without hits
/// keeps its standard deviation.
ScanShape with_scatter(const HitsAlongScan& mode, const ScanScatter& scatter);

}  // namespace percuss::identify
