#pragma once

namespace percuss::identify {

/// A mode's frequency and damping ratio against the magnitude of the hits' peak force, as straight lines, with standard
/// deviations.
struct AmplitudeTrend {
  double freq_slope_Hz_per_N = 0, freq_slope_std = 0, freq_at_zero_Hz = 0;
  double damping_slope_per_N = 0, damping_slope_std = 0, damping_at_zero = 0;
  bool freq_follows = false, damping_follows = false;  // whether the force explains their scatter
};

/// The relative change of a mode's frequency per hit, in the order of the test.
struct DriftTrend {
  double freq_change_per_hit = 0, std = 0;
};

}  // namespace percuss::identify
