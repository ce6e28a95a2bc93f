#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "metrics/deflection/deflection.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::pipeline {

struct ImpactTestOptions {
  metrics::DeflectionOptions deflection;
  std::optional<double> effective_mass_kg;  // of a free body, at the point of impact: gives its rigid motion
  std::optional<double> beam_distance_m;    // from the light beam to the structure
  double beam_time_s = 0;                   // when the ball broke the light beam, from the row's beginning
  std::vector<double> position_m;           // [points] in ascending order of the point numbers; empty: not known
};

/// The deflection at one accelerometer after one impact.
struct DeflectedHit {
  std::size_t hit = 0, channel = 0;
  int point = 0;
  std::optional<double> position_m;
  double first_s = 0;  // time of the deflection's first sample, from the row's beginning
  metrics::Deflection deflection;
};

/// The speed of the ball, from the light beam to the structure.
struct ImpactSpeed {
  std::size_t hit = 0;
  double speed_mps = 0, std_mps = 0;
};

/// The mean over the hits of one point, for one channel.
struct PointDeflection {
  int point = 0;
  std::size_t channel = 0, hits = 0;
  std::optional<double> position_m;
  bool directions_differ = false;  // of the hits' peaks: they have no mean
  double peak_m = 0;               // mean of the hits' peaks, signed; NaN where no hit has one or directions differ
  double std_m = 0;  // of the mean: from the hits' own ±, or from the scatter of two or more hits if larger
  // The same for deflections in the direction of the first motion of each hit, as a magnitude.
  double forward_m = 0, forward_std_m = 0;
};

struct ImpactTest {
  std::vector<DeflectedHit> hits;  // hit by hit, channel by channel; without the hits left out
  std::vector<ImpactSpeed> speeds;
  std::vector<PointDeflection> points;
  std::vector<Warning> warnings;
};

/// Deflection at each accelerometer for each impact with a pulse; without a force, each row is one impact. Hits that
/// percuss rejects for FRFs (a double hit, a truncated decay) have a deflection, too. Hits that the user rejects have
/// none. Hits without a pulse, with too many lost samples or with a clipped acceleration have one only if the user
/// accepts them; the modal method uses hits with a clipped acceleration in any case. Modes are identified only if the
/// method, stated or automatic, needs them.
/// errors  InputError: no force or no mode where the options need them; another number of positions than points; a
/// response that is a pressure; an impact less than one sample after the light beam.
ImpactTest deflect(const Analysis& analysis, const ImpactTestOptions& options = {});

}  // namespace percuss::pipeline
