#pragma once
#include <cstddef>
#include <vector>

#include "acquire/hits/hits.hpp"
#include "acquire/record/record.hpp"
#include "core/error.hpp"

namespace percuss::acquire {

/// The record is readable but contains no hit.
class NoHitError : public InputError {
 public:
  using InputError::InputError;
};

/// The result of one hit on the free mass.
struct CalibrationHit {
  std::size_t index = 0;  // among all hits of the record, as find_hits numbers them
  double time_s = 0;
  double peak_force = 0;  // in the channel's present unit
  double peak_accel_mps2 = 0;
  std::size_t samples = 0;  // the compared samples: the force exceeds half of its peak
  double scale = 0;         // N per present unit
  double scale_std = 0;     // from the residuals within the hit; of a single compared sample, from the noise before it
  double ringing = 0;       // rms of the acceleration after the pulse over the peak acceleration
  bool used = false;
};

struct Calibration {
  double scale = 0;      // N per present unit of the force channel; negative when it reads pushes as negative
  double scale_std = 0;  // the larger of the scatter between the hits and the noise within them
  std::vector<CalibrationHit> hits;
};

/// The force channel's scale from hits on a free mass: force = mass · acceleration. The scale of one hit is a
/// least-squares fit over the samples above half of the force's peak. The mean just before the hit is subtracted from
/// both signals. The result is the mean over the hits, weighted by the square of the peak force. Hits below a fifth of
/// the largest are left out. The sign makes a push positive.
/// errors  InputError: the record has not exactly one acceleration channel, or the acceleration goes on after the
/// pulses (a structure that rings is no free mass). NoHitError: the record contains no hit.
/// theory (1.6), (1.7)
Calibration calibrate(const Record& record, double mass_kg, const HitOptions& options = {});

}  // namespace percuss::acquire
