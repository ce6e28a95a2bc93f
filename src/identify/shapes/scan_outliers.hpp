#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "identify/shapes/scan_scatter.hpp"

namespace percuss::identify {

/// Hits at a point of a scan whose amplitudes do not fit the shapes through the other points.
struct ScanOutlier {
  std::size_t point = 0;          // of the shapes
  std::vector<std::size_t> hits;  // AmplitudeOfHit::hit of the hits that do not fit, ascending; empty: all of the point
  double deviations = 0;          // standard deviations from the curves, reached in at least two modes
  std::optional<double> fits_m;   // the position whose amplitudes they have, within the scan
};

/// The points that do not fit, ascending. The curve of a mode at a point is a polynomial through the twelve points
/// nearest to it. Its degree is the one with the least BIC, up to 5. One of the twelve is left out if this halves the
/// standard deviation of the rest on average over the modes: if two points are exchanged, each disturbs the curve at
/// the other. The variance of a deviation is a sum of four parts: the scatter of the other points about their curve (or
/// of the hits of one point, if this is larger), the uncertainty of the curve, its change by the next degree, and the
/// noise. A deviation below a tenth of the mode's largest amplitude near the point does not count. Modes with one shape
/// along the scan (MAC above 0.9), as the two planes of a bending mode, count once. A point does not fit if its mean or
/// one of its hits deviates by more than twelve standard deviations in two shapes. Nothing for fewer than eight points,
/// or if all modes have one shape.
/// theory (5.11)
std::vector<ScanOutlier> scan_outliers(std::span<const HitsAlongScan> modes);

}  // namespace percuss::identify
