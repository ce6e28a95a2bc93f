#pragma once
#include <span>

#include "metrics/deflection/baseline_drift.hpp"

namespace percuss::metrics {

/// The remaining bias of a held structure whose motion ends before the record does. Nothing swings there, so that the
/// windows of zero_mean_correction() hold no cycles. Four observations at the end of the record determine bias and
/// drift instead: the level and the slope of the acceleration, which are bias and drift alone where nothing moves, and
/// two Hann means of the deflection, which are zero at the position of rest. A body that flies away or hangs on bands
/// contradicts the means: after two rests the line is known far better than its motion is small.
///
/// The record ends at rest if the acceleration, from a sixth of the motion on or later, is a straight line and white
/// noise as strong as before the impact. Not held without noise before the impact, or if that noise is not white.
/// accel_mps2, deflection_m: as integrated, from the end of the samples at rest on, less the line in `rest`; for a free
/// body, the deflection less its rigid-body deflection. shapes [samples]. theory (7.13)
ZeroMeanCorrection final_rest_correction(std::span<const double> accel_mps2, std::span<const double> deflection_m,
                                         double fs_Hz, const BaselineEstimate& rest);

}  // namespace percuss::metrics
