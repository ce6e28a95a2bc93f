#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "acquire/hits/pulse_shape.hpp"

namespace percuss::acquire {

/// A push shorter than this fraction of the main pulse is a spike: it does not come from this hammer.
inline constexpr double kMaxSpikeLength = 0.5;

/// A further contact of the hammer: one push of the main pulse's sign and about its length.
struct SecondPulse {
  double delay_samples = 0;  // negative: before the main pulse
  double ratio = 0;          // its height over the main pulse's, both smoothed
  bool spike = false;        // see kMaxSpikeLength
  Gate gate;
};

/// The force beside the main pulse. A tail or the ringing of the hammer continues from the pulse without a pause and
/// belongs to it. A push is a contact if it stands alone, exceeds a tenth of the main pulse, or exceeds five times the
/// tail just before it. Ringing, which pulls as much as it pushes, is no contact; nor is a hump, which lasts several
/// times as long as the pulse.
/// theory (1.4)
struct FurtherForce {
  std::size_t end = 0;                // of the pulse with its tail and ringing
  std::vector<SecondPulse> contacts;  // ascending in time
};

struct FurtherForceOptions {
  std::size_t max_tail = 1280;  // samples; force that lasts longer is drift
};

/// `pulse_gate` is gate_around of the pulse.
FurtherForce further_force(std::span<const double> force_N, const PulseShape& pulse, const Gate& pulse_gate,
                           double noise_N, const FurtherForceOptions& options = {});

}  // namespace percuss::acquire
